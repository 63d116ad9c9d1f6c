// A pattern and its values at five points, from POV-Ray.
#pragma once

#include <gtest/gtest.h>

#include <span>

#include "tracer/textures/patterns/formulas.h"
#include "tracer/textures/texture.h"

namespace verisim::textures {

using namespace scene;

struct Probe {
  const char* sdl;
  Pattern (*make)();
  double value[5];
};

inline Pattern make(PatternKind kind) {
  Pattern p;
  p.kind = kind;
  switch (kind) {
    case PatternKind::marble:
    case PatternKind::wood:
    case PatternKind::spiral1:
    case PatternKind::spiral2:
      p.wave = Wave::triangle;
      break;
    case PatternKind::checker:
    case PatternKind::brick:
    case PatternKind::hexagon:
    case PatternKind::cubic:
    case PatternKind::quilted:
      p.frequency = 0;
      break;
    default:
      break;
  }
  return p;
}

inline Turbulence& classic(Pattern& p) { return p.turbulence.edit(); }

inline void check(std::span<const Probe> probes, std::span<const Vec3, 5> points, double tolerance) {
  for (const Probe& probe : probes) {
    Compiler compiler{Settings{}};
    const CompiledPattern* pattern = compiler.pattern(probe.make());
    for (int k = 0; k < 5; ++k)
      EXPECT_NEAR(evaluate(*pattern, points[k], nullptr), probe.value[k], tolerance) << probe.sdl << ", point " << k;
  }
}

}  // namespace verisim::textures
