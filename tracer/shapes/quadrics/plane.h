// Where a ray meets a plane: shared by the shape and by what tests many rays against it at once (spec 03 4.5).
#pragma once

#include <cmath>

#include "tracer/math/vec.h"

namespace verisim::shapes {

inline constexpr double kNearestPlane = 1e-6, kFarthestPlane = 1e7;

// `slope`: normal . direction; `t`: (distance - normal . origin) / slope.
inline bool meets_plane(double slope, double t) {
  return !(std::fabs(slope) < kEpsilon) && t >= kNearestPlane && t <= kFarthestPlane;
}

}  // namespace verisim::shapes
