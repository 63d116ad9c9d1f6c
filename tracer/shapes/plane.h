// Where a ray meets a plane: shared by the shape and by what tests many rays against it at once (spec 03 4.5).
#pragma once

#include <optional>

#include "tracer/math/vec.h"
#include "tracer/scene/object.h"
#include "tracer/shapes/half_spaces.h"

namespace verisim::shapes {

inline constexpr double kNearestPlane = 1e-6, kFarthestPlane = 1e7;

// `slope`: normal . direction; `t`: (distance - normal . origin) / slope.
inline bool meets_plane(double slope, double t) { return !(std::fabs(slope) < kEpsilon) && t >= kNearestPlane && t <= kFarthestPlane; }

// A plane without a matrix and clips: rays may be tested against it in place.
inline std::optional<scene::Plane> plain_plane(const scene::Object& o) {
  const auto* plane = o.as<scene::Plane>();
  if (!plane || o.transform || !o.bounded_by.empty() || !o.clipped_by.empty()) return std::nullopt;
  return *plane;
}

// Where such a plane is solid.
inline std::optional<HalfSpace> half_space_of(const scene::Object& o) {
  const auto plane = plain_plane(o);
  if (!plane) return std::nullopt;
  return o.inverted ? HalfSpace{-plane->normal, -plane->distance - kEpsilon} : HalfSpace{plane->normal, plane->distance + kEpsilon};
}

}  // namespace verisim::shapes
