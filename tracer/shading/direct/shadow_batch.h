// Shadow rays to one light that are traced together: from the surfaces of a wavefront, or from places along a ray
// through a medium.
#pragma once

#include "tracer/math/ray_batch.h"
#include "tracer/shading/random.h"
#include "tracer/shading/tracer.h"

namespace verisim::shading {

struct ShadowBatch {
  static constexpr int kMax = RayBatch::kMax;

  int count = 0;
  RayBatch rays;                     // directions are unit vectors towards the light
  double distance[RayBatch::kSize];  // of the light
  Rgb light[kMax];                   // what arrives if nothing is in the way; then what arrives
  const shapes::Surface* lit[kMax];  // null: no surface
  RandomSource::Key key[kMax];       // of what each draws on its way

  void add(const Ray& ray, double d, const Rgb& color, const shapes::Surface* surface, RandomSource::Key k) {
    rays.origin.set(count, ray.origin), rays.direction.set(count, ray.direction);
    distance[count] = d, light[count] = color, lit[count] = surface, key[count] = k;
    ++count;
  }
};

}  // namespace verisim::shading
