// The matrix of shapes that are modelled along the z axis (cone, cylinder, disc).
#pragma once

#include "tracer/math/transform.h"

namespace verisim::shapes {

// Takes z = 0 .. 1, radius 1 to `length` along `axis` (unit) from `origin`, by the smallest rotation from z to the
// axis.
Transform frame_along(const Vec3& origin, const Vec3& axis, double radius, double length);

}  // namespace verisim::shapes
