// Where a ray meets a plane: shared by the shape and by what tests many rays against it at once (spec 03 4.5).
#pragma once

#include "tracer/math/vec.h"

namespace verisim::shapes {

// `slope`: normal . direction; `t`: (distance - normal . origin) / slope.
inline bool meets_plane(double slope, double t) {
  constexpr double kNearest = 1e-6, kFarthest = 1e7;
  return !(std::fabs(slope) < kEpsilon) && t >= kNearest && t <= kFarthest;
}

}  // namespace verisim::shapes
