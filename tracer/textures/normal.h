// A compiled normal: how a pattern perturbs the surface normal (spec 05 section 10).
#pragma once

#include "tracer/textures/blend_map.h"
#include "tracer/textures/pattern.h"

namespace verisim::textures {

struct CompiledNormal {
  enum class Method : std::uint8_t {
    displacement,  // the pattern has a vector of its own: bumps, dents, wrinkles, ripples, waves, quilted, facets, bump_map
    height,        // slope of the pattern's value
    map,           // normal_map or list
    average,
    uv_mapping,
  };
  Method method = Method::height;
  const CompiledPattern* pattern = nullptr;
  double amount = 0.5, accuracy = 0.02;
  bool no_bump_scale = false;
  MapPositions positions;  // of normal_map or slope_map; the weights of average
  std::vector<scene::SlopeEntry> slopes;
  std::vector<const CompiledNormal*> children;
};

}  // namespace verisim::textures
