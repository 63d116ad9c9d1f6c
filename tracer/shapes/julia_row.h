// Rays of a row that march through a Julia fractal in step: each takes the steps it takes alone (julia_fractal.cpp), so its hit is the same.
#pragma once

#include "tracer/shapes/julia_lanes.h"

namespace verisim::shapes::julia {

inline constexpr double kFine = 1e-7;  // tolerance of depths

// Where the march of each ray begins and must end; behind `last` it finds nothing, and behind `limit` it is of no use.
struct alignas(64) Stretch {
  double begin[kLanes], end[kLanes], last[kLanes], limit[kLanes];
};

// The lanes of `asked` whose rays cross the surface, and the depths of their first crossings. Not for Kind::other.
unsigned first_crossings(const Field& field, const Rays& rays, const Stretch& stretch, unsigned asked, double depth[kLanes]);

}  // namespace verisim::shapes::julia
