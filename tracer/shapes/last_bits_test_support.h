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

}  // namespace verisim::shapes::testing
