// What fills space and solids: media, interiors, fog, skies.
#include "parser/keywords/keywords.h"

namespace verisim::parser {
namespace {

constexpr Keyword kAtmosphereWords[] = {
    {"aa_level", "media", "aa_level N", "3", "Method 3: how often an interval is divided at most."},
    {"aa_threshold", "media", "aa_threshold A", "0.1", "Method 3: differences above this are divided further."},
    {"absorption", "media", "absorption COLOR", "0", "How much light the medium swallows per unit of length."},
    {"angle", "rainbow", "angle A", "0", "Half the opening angle of the bow, in degrees; 42 in nature."},
    {"arc_angle", "rainbow", "arc_angle A", "180", "How much of the circle is seen, in degrees."},
    {"background", "scene", "background { COLOR }", "black, transparent", "The colour where nothing is hit."},
    {"collect", "media", "collect BOOL", "on", "Whether the medium is lit by photons."},
    {"confidence", "media", "confidence A", "0.9",
     "Methods 1 and 2: how sure the result must be before sampling ends."},
    {"direction", "rainbow", "direction V", "", "Where the light comes from: away from the sun."},
    {"dispersion", "interior", "dispersion A", "1",
     "How much the index of refraction differs between red and violet: 1.01 to 1.1 shows colours."},
    {"dispersion_samples", "interior", "dispersion_samples N", "7", "In how many colours light is split."},
    {"distance", "fog", "distance D", "", "How far one sees: after D, 37 % of the light is left."},
    {"distance", "rainbow", "distance D", "far away", "How far the rainbow is: what is nearer covers it."},
    {"eccentricity", "scattering", "eccentricity A", "0", "Of scattering type 5: forward above 0, back below."},
    {"emission", "media", "emission COLOR", "0", "How much light the medium gives off per unit of length."},
    {"emission", "sky_sphere", "emission COLOR", "1", "Multiplies the colours of the sky."},
    {"extinction", "scattering", "extinction A", "1", "How much of the scattered light is missing behind the medium."},
    {"fade_color", "interior", "fade_color COLOR", "black",
     "The colour that light keeps on its way through the object."},
    {"fade_colour", "interior", "fade_colour COLOUR", "black", "The same as fade_color."},
    {"fade_distance", "interior", "fade_distance D", "0",
     "After this way through the object half of the light is gone."},
    {"fade_power", "interior", "fade_power P", "0",
     "How light fades with the way through the object; 1000 and more: exponentially, as in nature."},
    {"falloff_angle", "rainbow", "falloff_angle A", "arc_angle",
     "Where the ends of the bow begin to fade, in degrees."},
    {"fog", "scene value", "fog { distance D COLOR [fog_type 2 fog_offset Y fog_alt H] [turbulence V turb_depth A] }",
     "", "Haze that hides what is far away."},
    {"fog_alt", "fog", "fog_alt H", "0", "Ground fog: how quickly it thins out above fog_offset."},
    {"fog_offset", "fog", "fog_offset Y", "0", "Ground fog is even below this height."},
    {"fog_type", "fog", "fog_type 1|2", "1", "1 is the same everywhere, 2 lies on the ground."},
    {"intervals", "media", "intervals N", "1", "In how many pieces the way through the medium is divided."},
    {"ior", "interior", "ior A", "1", "The index of refraction: air 1, water 1.33, glass 1.5, diamond 2.4."},
    {"jitter", "media", "jitter A", "0", "Method 3: shakes the samples, which turns stripes into grain."},
    {"jitter", "rainbow", "jitter A", "0", "Random grain of the bow."},
    {"media", "scene interior value", "media { absorption C emission C scattering { ... } density { ... } }", "",
     "Smoke, fire, clouds, dust: what is within a hollow object, or everywhere."},
    {"method", "media", "method 1|2|3", "3", "How the medium is sampled: 1 at random, 2 evenly, 3 adaptively."},
    {"rainbow", "scene value", "rainbow { direction V angle A width W color_map { ... } distance D }", "",
     "A bow of colours opposite to the sun."},
    {"ratio", "media", "ratio A", "0.9", "How samples are shared between lit and dark intervals."},
    {"samples", "media", "samples MIN [, MAX]", "10", "How many samples an interval has."},
    {"scattering", "media", "scattering { TYPE, COLOR [eccentricity A] [extinction A] }", "",
     "Light that the medium throws aside. Types: 1 isotropic, 2 Mie (haze), 3 Mie (murky), 4 Rayleigh, 5 "
     "Henyey-Greenstein."},
    {"sky_sphere", "scene value", "sky_sphere { PIGMENT ... [emission C] }", "",
     "A sky infinitely far away: its pigments are asked with directions."},
    {"turb_depth", "fog", "turb_depth A", "0.5", "How far along the ray turbulence is asked."},
    {"up", "fog", "up V", "y", "Which way is up for ground fog."},
    {"up", "rainbow", "up V", "y", "Where the middle of a partial bow is."},
    {"variance", "media", "variance A", "1/128", "Methods 1 and 2: how much samples may differ before sampling ends."},
    {"width", "rainbow", "width A", "0", "How wide the bow is, in degrees."},
};

}  // namespace

const KeywordSection kAtmosphere{
    "Interiors, media, fog and skies", "atmosphere",
    "What fills objects and the space between them. Objects with media inside must be `hollow`.", kAtmosphereWords};

}  // namespace verisim::parser
