// The box of what lies on the inner side of several planes: solids cut out by planes are small though each plane is infinite.
#pragma once

#include <span>

#include "tracer/math/vec.h"

namespace verisim::shapes {

// normal . p <= distance.
struct HalfSpace {
  Vec3 normal;
  double distance;
};

// A conservative box of the points of `known` that lie in all half spaces; sides may be infinite. Empty if nothing lies in all of them.
Box3 narrowed(const Box3& known, std::span<const HalfSpace> half_spaces);

}  // namespace verisim::shapes
