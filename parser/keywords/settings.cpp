// global_settings, radiosity, photons.
#include "parser/keywords/keywords.h"

namespace verisim::parser {
namespace {

constexpr Keyword kTable[] = {
    // clang-format off
    {"adc_bailout", "global_settings global_radiosity global_photons", "adc_bailout A", "1/255, in radiosity 0.01", "Rays that count less than this are not followed."},
    {"always_sample", "global_radiosity", "always_sample BOOL", "off", "Whether samples are still taken in the final picture; off avoids blotches when there are enough."},
    {"ambient_light", "global_settings", "ambient_light COLOR", "rgb 1", "Multiplies the ambient of all finishes."},
    {"ascii", "+charset", "charset ascii", "ascii", "Strings are ASCII."},
    {"assumed_gamma", "global_settings", "assumed_gamma A | srgb", "1 since version 3.7, before: none", "The gamma that colours of the scene are written in: 1.0 is linear light, as it should be."},
    {"autostop", "global_photons", "autostop A", "0.5", "From which part of its shots on a light may stop when nothing is hit any more; 1 shoots all."},
    {"brightness", "global_radiosity", "brightness A", "1", "Multiplies the gathered light."},
    {"charset", "global_settings", "charset ascii|utf8|sys", "ascii", "How bytes above 127 of strings are read."},
    {"count", "global_radiosity", "count N [, POOL]", "35", "How many rays a sample of radiosity sends out: more is smoother and slower."},
    {"count", "global_photons", "count N", "", "How many photons are shot, about; instead of spacing."},
    {"error_bound", "global_radiosity", "error_bound A", "1.8", "How large errors may be: less needs more samples and shows finer shadows."},
    {"expand_thresholds", "global_photons", "expand_thresholds INCREASE, MIN", "0.2, 35", "When the search for photons is widened."},
    {"gather", "global_photons", "gather MIN, MAX", "20, 100", "How many photons are mixed at a point."},
    {"global_settings", "scene", "global_settings { ITEM ... }", "", "What holds for the whole scene."},
    {"gray_threshold", "global_radiosity", "gray_threshold A", "0", "How much colours bleed: 0 fully, 1 not at all."},
    {"hf_gray_16", "global_settings", "hf_gray_16 [BOOL]", "off", "Old: writes heights as 16 bits of grey; use File_Gamma and Grayscale_Output."},
    {"irid_wavelength", "global_settings", "irid_wavelength COLOR", "rgb <0.70, 0.52, 0.48>", "The wavelengths that irid computes with."},
    {"jitter", "global_photons", "jitter A", "0.4", "Shakes the directions of photons."},
    {"load_file", "global_radiosity global_photons", "load_file \"file\"", "", "Reads what an earlier render saved."},
    {"low_error_factor", "global_radiosity", "low_error_factor A", "0.5", "How much finer the pretrace is than the final picture."},
    {"max_intersections", "global_settings scene", "max_intersections N", "", "Without effect since 3.7."},
    {"max_sample", "global_radiosity", "max_sample A", "no limit", "Cuts very bright samples off, against white spots."},
    {"max_trace_level", "global_settings global_photons scene", "max_trace_level N", "5", "How often a ray may be mirrored or refracted: raise it for glass."},
    {"maximum_reuse", "global_radiosity", "maximum_reuse A", "0.2", "Up to which distance a sample is used at most, as a share of the picture's width."},
    {"media", "global_radiosity", "media BOOL", "off", "Whether media are seen by gathering rays."},
    {"media", "global_photons", "media STEPS [, FACTOR]", "0", "How many photons are left in media on their way; 0: none."},
    {"minimum_reuse", "global_radiosity", "minimum_reuse A", "0.015", "Below which distance samples are not refined further."},
    {"mm_per_unit", "global_settings", "mm_per_unit A", "10", "How many millimetres a unit of the scene is, for subsurface."},
    {"nearest_count", "global_radiosity", "nearest_count N [, ADAPTIVE]", "5", "How many samples are blended at a point, 1 to 20."},
    {"noise_generator", "global_settings", "noise_generator 1|2|3", "2 since version 3.5, before: 1", "The noise that patterns are made of: 1 original, 2 with even range, 3 Perlin noise."},
    {"number_of_waves", "global_settings", "number_of_waves N", "10", "From how many centres waves and ripples come."},
    {"photons", "global_settings", "photons { spacing A | count N ITEM ... }", "off", "Turns photon mapping on: caustics of mirrors and glass."},
    {"pretrace_end", "global_radiosity", "pretrace_end A", "0.04", "The size of squares, as a share of the picture, that the pretrace ends with."},
    {"pretrace_start", "global_radiosity", "pretrace_start A", "0.08", "The size of squares that the pretrace starts with."},
    {"radiosity", "global_settings", "radiosity { ITEM ... }", "off", "Turns light from surface to surface on."},
    {"radiosity", "global_subsurface", "subsurface { radiosity BOOL }", "off", "Whether radiosity goes below surfaces."},
    {"radius", "global_photons", "radius A [, STEP] [, MEDIA] [, STEP]", "", "How far photons are looked for; mostly best left out."},
    {"recursion_limit", "global_radiosity", "recursion_limit N", "2", "How often light goes from surface to surface."},
    {"samples", "global_subsurface", "samples DIFFUSE, SINGLE", "50, 50", "How many samples light below surfaces has."},
    {"save_file", "global_radiosity global_photons", "save_file \"file\"", "", "Saves what was computed, for load_file."},
    {"spacing", "global_photons", "spacing A", "", "How far apart photons are on the target: smaller shoots more."},
    {"steps", "", "", "", "Reserved: old versions used it for halos; nothing takes it."},
    {"subsurface", "global_settings", "subsurface { samples A, B [radiosity BOOL] }", "off", "Turns light below surfaces on, for finishes with subsurface."},
    {"subsurface", "global_radiosity", "subsurface BOOL", "off", "Whether gathering rays see light below surfaces."},
    {"sys", "+charset", "charset sys", "", "Strings are in the encoding of the system."},
    {"utf8", "+charset", "charset utf8", "", "Strings are UTF-8."},
    // clang-format on
};

}  // namespace

const KeywordSection kSettings{"Settings of the whole scene", "settings",
                               "`global_settings` and what is below it: radiosity, photons, subsurface.", kTable};

}  // namespace verisim::parser
