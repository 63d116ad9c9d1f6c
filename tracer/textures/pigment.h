// A compiled pigment or density: where its colour comes from.
#pragma once

#include "tracer/textures/blend_map.h"
#include "tracer/textures/pattern.h"

namespace verisim::textures {

struct CompiledPigment {
  enum class Source : std::uint8_t { plain, color_map, pigment_map, average, uv_mapping, image };
  Source source = Source::plain;
  Color color;                                   // plain
  const CompiledPattern* pattern = nullptr;      // all but plain
  MapPositions positions;                        // of the maps; the weights of average
  std::vector<Color> colors;                     // color_map
  std::vector<const CompiledPigment*> children;  // pigment_map, average, uv_mapping
  float total_weight = 0;                        // average
  bool transparent = false;                      // some entry filters or transmits, or may have no colour (spec 05 11.4)
};

// The map that a pattern brings when none is written (spec 05 4.3).
scene::ColorMap built_in_map(const scene::Pattern& pattern);

}  // namespace verisim::textures
