// The measured Cornell box as numbers for a renderer with three channels.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tools/spectra/spectrum.h"

namespace verisim::spectra {

struct CornellBox {
  std::map<std::string, Triple> reflectance;  // linear sRGB, by material: white, green, red
  Triple light_color{};                       // linear sRGB, luminance 1
  double light_reflectance = 0;
  double light_area = 0;      // square millimetres
  double room_area = 0;       // of the walls, floor, ceiling and the open front
  Triple mean_reflectance{};  // over room_area; the open front reflects nothing
};

// Throws std::runtime_error (missing file, not the expected content).
CornellBox read_cornell_box(const std::filesystem::path& json, Illuminant illuminant = Illuminant::d65);

// The form of wavelength bands renders three bands of 25 nm from 400 nm on a picture, one a channel, with the light
// relative to its mean (bands.inc). How the linear values of picture p add up to linear sRGB: [p][row][channel], so
// that the light has luminance 1 as in light_color. Throws std::runtime_error.
inline constexpr int kBands = 12, kBandWidth = 25, kFirstBand = 400;
using BandMatrix = std::array<Triple, 3>;
std::array<BandMatrix, 4> band_matrices(const std::filesystem::path& json);
// Mean of a spectrum over band b.
double band_mean(const Spectrum& spectrum, int band);
// As `passes` of a manifest.
std::string as_passes(const std::array<BandMatrix, 4>& matrices);

// As #declare lines of the scene language.
std::string as_sdl(const CornellBox& box);

}  // namespace verisim::spectra
