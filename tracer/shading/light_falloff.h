// How light from a point fades with angle and distance (spec 06 section 7.3), a row of points at a time. Compiled for several instruction sets; every lane does the operations of
// Light::attenuation in the same order.
#pragma once

#include <optional>

#include "tracer/math/ray_row.h"
#include "tracer/shading/light.h"

namespace verisim::shading {

struct LightFalloff {
  bool spot = false, soft = false, fades = false;  // soft: within a cone, and beyond it less and less
  int tightness = 0, power = 0;                    // exponents: 0, 1 or 2
  Vec3 direction{0, 0, 0};                         // of a spot light
  double cos_radius = 0, cos_falloff = 0, fade_distance = 1;

  // None: not so simple.
  static std::optional<LightFalloff> of(const Light& light);
  // Of points with unit directions towards the light; room for whole registers behind the last.
  void attenuate(const RayRow::Vectors& towards, const double* distance, int count, float* attenuation) const;
};

struct LightFalloffKernels {
  void (*attenuate)(const LightFalloff& falloff, const RayRow::Vectors& towards, const double* distance, int count, float* attenuation);
};
// Those of any instruction set, for tests; null: this machine cannot run it.
const LightFalloffKernels* light_falloff_kernels(int instruction_set);

}  // namespace verisim::shading
