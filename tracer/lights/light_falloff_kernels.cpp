#include "tracer/lights/light_falloff.h"
#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/lights/light_falloff_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "hwy/highway.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shading {
namespace {
namespace HWY_NAMESPACE {

// Plain loops, which the compiler turns into wide instructions. Conditions are written with & and |, so that nothing
// branches.

constexpr int rounded(int count) { return (count + RayBatch::kStep - 1) / RayBatch::kStep * RayBatch::kStep; }

HWY_INLINE void set_direction(const Vec3& to, int i, RayBatch& to_light, double* distance) {
  const LightDirection l = radial_direction(to);
  to_light.direction.set(i, l.towards), distance[i] = l.distance;
}

void aim(const Vec3& position, int count, RayBatch& to_light, double* distance) {
  const int end = rounded(count);
  for (int i = 0; i < end; ++i) set_direction(position - to_light.origin.at(i), i, to_light, distance);
}

void aim_at_grid(const LightGrid& grid, const Vec3& p, const GridPlaces& places, int count, RayBatch& to_light,
                 double* distance) {
  const Vec3 position = grid.position, a1 = grid.a1, a2 = grid.a2;
  const double last1 = grid.last1, last2 = grid.last2;
  const int end = rounded(count);
  if (grid.circular) {
    for (int i = 0; i < end; ++i) {
      const double a = places.u[i] / last1 - 0.5, b = places.v[i] / last2 - 0.5;
      set_direction(position + disc_offset(a1, a2, a, b) - p, i, to_light, distance);
    }
  } else {
    for (int i = 0; i < end; ++i) {
      const Vec3 offset = Vec3(0.0) + a1 * (places.u[i] / last1 - 0.5) + a2 * (places.v[i] / last2 - 0.5);
      set_direction(position + offset - p, i, to_light, distance);
    }
  }
}

template <int kExponent>
double raised(double base) {
  if constexpr (kExponent == 0)
    return 1;
  else if constexpr (kExponent == 1)
    return base;
  else
    return base * base;
}

template <int kTightness>
void spot(const LightFalloff& f, const RayBatch::Vectors& towards, const double* distance, int end, double* a) {
  const Vec3 d = f.direction;
  const double low = f.cos_falloff, high = f.cos_radius, soft = f.soft_below;
  for (int i = 0; i < end; ++i) {
    const double along = dot(towards.at(i), d), m = distance[i] > 0 ? -along : along;
    a[i] = spot_profile(m, raised<kTightness>(m), low, high, soft);
  }
}

template <int kPower>
void fade(double fade_distance, const double* distance, int end, double* a) {
  for (int i = 0; i < end; ++i) {
    const double left = a[i] * faded(raised<kPower>(distance[i] / fade_distance));
    a[i] = a[i] == 0 ? 0 : left;
  }
}

void attenuate(const LightFalloff& f, const RayBatch::Vectors& towards, const double* distance, int count, double* a) {
  const int end = rounded(count);
  if (!f.spot)
    std::fill_n(a, end, 1.0);
  else if (f.tightness == 0)
    spot<0>(f, towards, distance, end, a);
  else if (f.tightness == 1)
    spot<1>(f, towards, distance, end, a);
  else
    spot<2>(f, towards, distance, end, a);
  if (f.fades && f.power == 1) fade<1>(f.fade_distance, distance, end, a);
  if (f.fades && f.power == 2) fade<2>(f.fade_distance, distance, end, a);
}

constexpr LightFalloffKernels kKernels = {aim, aim_at_grid, attenuate};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shading
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shading {
VERISIM_EXPORT_KERNELS(LightFalloffKernels, light_falloff_kernels)
}  // namespace verisim::shading
#endif
