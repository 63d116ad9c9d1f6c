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
  double light_area = 0;                      // square millimetres
  double room_area = 0;                       // of the walls, floor, ceiling and the open front
  Triple mean_reflectance{};                  // over room_area; the open front reflects nothing
};

// Throws std::runtime_error (missing file, not the expected content).
CornellBox read_cornell_box(const std::filesystem::path& json, Illuminant illuminant = Illuminant::d65);

// As #declare lines of the scene language.
std::string as_sdl(const CornellBox& box);

}  // namespace verisim::spectra
