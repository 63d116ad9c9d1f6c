// Where a light is from a batch of points, where the samples of an area light are from one, and how light fades with
// angle and distance (spec 06 sections 7.3 and 8). Compiled for several instruction sets; every lane does the
// operations of Light::direction, Light::offset and Light::attenuation in the same order.
#pragma once

#include <optional>

#include "tracer/math/ray_batch.h"
#include "tracer/lights/light.h"

namespace verisim::shading {

struct LightFalloff {
  bool spot = false, fades = false;
  int tightness = 0, power = 0;  // exponents: 0, 1 or 2; if it fades, 1 or 2
  Vec3 direction{0, 0, 0};       // of a spot light
  double cos_radius = 0, cos_falloff = 0, soft_below = 0, fade_distance = 1;

  // None: not so simple.
  static std::optional<LightFalloff> of(const Light& light);
  // Of points with unit directions towards the light; room for whole registers behind the last.
  void attenuate(const RayBatch::Vectors& towards, const double* distance, int count, double* attenuation) const;
};

// Sets the unit directions from points to the light's centre, and its distances. Points: to_light.origin.
void aim_at(const Light& light, int count, RayBatch& to_light, double* distance);

// Positions in the grid of an area light, jitter included.
struct GridPlaces {
  double u[RayBatch::kSize], v[RayBatch::kSize];
};
// Sets the unit directions from p to places on an area light, and their distances; `axes` are those at p.
void aim_at_grid(const Light& light, const Light::Axes& axes, const Vec3& p, const GridPlaces& places, int count,
                 RayBatch& to_light, double* distance);

// An area light as the kernels see it.
struct LightGrid {
  Vec3 position, a1, a2;  // an axis has no length where there is one sample along it
  double last1, last2;    // columns and rows, less one
  bool circular;

  LightGrid(const Light& light, const Light::Axes& axes);
};

struct LightFalloffKernels {
  void (*aim)(const Vec3& position, int count, RayBatch& to_light, double* distance);
  void (*aim_at_grid)(const LightGrid& grid, const Vec3& p, const GridPlaces& places, int count, RayBatch& to_light,
                      double* distance);
  void (*attenuate)(const LightFalloff& falloff, const RayBatch::Vectors& towards, const double* distance, int count,
                    double* attenuation);
};
// Those of any instruction set, for tests; null: this machine cannot run it.
const LightFalloffKernels* light_falloff_kernels(int instruction_set);
// Those of the best instruction set of this machine.
const LightFalloffKernels& light_falloff_kernels();

}  // namespace verisim::shading
