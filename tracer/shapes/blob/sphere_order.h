// POV-Ray's hierarchy of the spheres around a blob's parts, for one purpose: the order in which parts are added up,
// which decides the last digits of sums (spec 08 N).
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/math/vec.h"

namespace verisim::shapes::blob {

struct BoundingSphere {
  Vec3 center;
  double radius = 0;
};

// The spheres from left to right in the hierarchy.
std::vector<std::uint32_t> order_of(const std::vector<BoundingSphere>& spheres);

}  // namespace verisim::shapes::blob
