// The angle and latitude maps of spec 03 4.0.
#pragma once

#include <numbers>

#include "tracer/math/vec.h"

namespace verisim::shapes {

// Angle of (x, z) from +x towards +z as a fraction of a turn, in [0, 1); 0 on the axis.
inline double turn_fraction(double x, double z) {
  const double length2 = x * x + z * z;
  if (length2 <= kEpsilon) return 0;
  const double angle = std::acos(x / std::sqrt(length2));
  return (z < 0 ? 2 * std::numbers::pi - angle : angle) / (2 * std::numbers::pi);
}

// d: unit vector from the centre.
inline Vec2 spherical_uv(const Vec3& d) {
  const double y = d.y < -1 ? -1 : d.y > 1 ? 1 : d.y;
  return {turn_fraction(d.x, d.z), 0.5 + std::asin(y) / std::numbers::pi};
}

}  // namespace verisim::shapes
