// A plane and one ray: shared by the shape and by what looks at the planes of a scene before all else.
#pragma once

#include "tracer/math/vec.h"
#include "tracer/shapes/intersections.h"

namespace verisim::shapes::one_ray {
#include "tracer/shapes/quadrics/plane_intersections.inc"
}  // namespace verisim::shapes::one_ray
