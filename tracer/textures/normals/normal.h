// A compiled normal: how a pattern perturbs the surface normal (spec 05 section 10).
#pragma once

#include "tracer/textures/lookup/blend_map.h"
#include "tracer/textures/patterns/pattern.h"

namespace verisim::textures {

struct CompiledNormal {
  enum class Method : std::uint8_t {
    displacement,  // the pattern has a vector of its own: bumps, dents, wrinkles, ripples, waves, quilted, facets,
                   // bump_map
    height,        // slope of the pattern's value
    map,           // normal_map or list
    average,
    uv_mapping,
    unusable,
  };
  Method method = Method::height;
  const CompiledPattern* pattern = nullptr;
  double amount = 0.5, accuracy = 0.02;
  bool no_bump_scale = false;
  MapPositions positions;  // of normal_map or slope_map; the weights of average
  std::vector<scene::SlopeEntry> slopes;
  std::vector<const CompiledNormal*> children;
};

// The whole process of one normal, children included. `surface.normal` is what patterns see: what the evaluation before
// this one has left, not n (spec 05 3.4).
Vec3 perturb_alone(const CompiledNormal& c, const Vec3& p, const Vec3& n, SurfacePoint& surface);

// A slope of heights is measured at the corners of a small pyramid (spec 05 10.3): directions from the point, and what
// heights are multiplied by.
inline const Vec3 kHeightSamples[4] = {{0.942809041, -0.333333333, 0},
                                       {-0.471404521, -0.333333333, 0.816496581},
                                       {-0.471404521, -0.333333333, -0.816496581},
                                       {0, 1, 0}};
inline double height_strength(const CompiledNormal& c) { return c.amount * -5 * (0.02 / c.accuracy); }
// From the pattern's value to the height: the slope_map, if there is one.
double height_of(const CompiledNormal& c, double v);

}  // namespace verisim::textures
