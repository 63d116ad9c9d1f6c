// Shadow rays to one light that are traced together: from the surfaces of a wave, or from places along a ray through a
// medium.
#pragma once

#include <array>

#include "tracer/math/ray_row.h"
#include "tracer/shading/random.h"
#include "tracer/shading/tracer.h"

namespace verisim::shading {

struct ShadowRow {
  static constexpr int kMost = RayRow::kMost;

  int count = 0;
  RayRow rays;                        // directions are unit vectors towards the light
  double distance[RayRow::kSize];     // of the light
  Rgb light[kMost];                   // what arrives if nothing is in the way; then what arrives
  const shapes::Surface* lit[kMost];  // null: no surface
  RandomSource::Key key[kMost];       // of what each draws on its way

  void add(const Ray& ray, double d, const Rgb& color, const shapes::Surface* surface, RandomSource::Key k) {
    rays.origin.set(count, ray.origin), rays.direction.set(count, ray.direction);
    distance[count] = d, light[count] = color, lit[count] = surface, key[count] = k;
    ++count;
  }
};

// The rays of a row, from surfaces or from places in space.
struct ShadowRays {
  const RayRow& rays;
  const double* distance;
  const shapes::Surface* const* lit;  // null: no surfaces
  int count;
  const shapes::Surface* surface(int i) const { return lit ? lit[i] : nullptr; }
};

// What is known of the way to a light.
enum class LightWay : unsigned char { unknown, blocked, open };
using LightWays = std::array<LightWay, ShadowRow::kMost>;

}  // namespace verisim::shading
