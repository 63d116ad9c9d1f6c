#include "tracer/shapes/frame.h"

#include <algorithm>
#include <numbers>

namespace verisim::shapes {

Transform frame_along(const Vec3& origin, const Vec3& axis, double radius, double len) {
  const Transform scaled = Transform::scaling({radius, radius, len});
  Transform turned;
  if (std::fabs(axis.z) > 1.0 - kEpsilon) {
    turned = Transform::axis_rotation({1, 0, 0}, axis.z < 0 ? std::numbers::pi : 0.0);
  } else {
    turned = Transform::axis_rotation(cross({0, 0, 1}, axis), std::acos(std::clamp(axis.z, -1.0, 1.0)));
  }
  return scaled.then(turned).then(Transform::translation(origin));
}

}  // namespace verisim::shapes
