// The microscope of spec 08 N: hits and normals of POV-Ray's trace(), all bits of them. Chaotic scenes (mirrors in
// mirrors, surfaces in the same place) hang on the last one.
#pragma once

#include "tracer/shapes/test_support.h"

namespace verisim::shapes::testing {

struct Probe {
  Vec3 from, direction, point, normal;
};

inline void expect_bits(const ObjectRef& object, const std::vector<Probe>& probes) {
  for (const Probe& p : probes) expect_trace(object, p.from, p.direction, p.point, p.normal, 0);
}

// What inside() says at hits of the object itself: where two of it lie in one place in CSG, that decides.
inline void expect_insides(const ObjectRef& object, const std::vector<std::pair<Vec3, bool>>& points) {
  for (const auto& [point, is_inside] : points) EXPECT_EQ(inside(object, point), is_inside) << point;
}

}  // namespace verisim::shapes::testing
