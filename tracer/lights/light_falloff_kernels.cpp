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

void aim(const Vec3& position, int count, RayBatch& to_light, double* distance) {
  const double lx = position.x, ly = position.y, lz = position.z;
  const auto& from = to_light.origin;
  auto& to = to_light.direction;
  const int end = rounded(count);
  for (int i = 0; i < end; ++i) {
    const double x = lx - from.x[i], y = ly - from.y[i], z = lz - from.z[i];
    const double d = std::sqrt(x * x + y * y + z * z), inverse = 1 / d;
    distance[i] = d;
    to.x[i] = x * inverse, to.y[i] = y * inverse, to.z[i] = z * inverse;
  }
}

template <class Offset>
void aim_at_offsets(const Vec3& position, const Vec3& p, int count, RayBatch& to_light, double* distance,
                    const Offset& offset) {
  const double lx = position.x, ly = position.y, lz = position.z, px = p.x, py = p.y, pz = p.z;
  auto& to = to_light.direction;
  const int end = rounded(count);
  for (int i = 0; i < end; ++i) {
    double ox, oy, oz;
    offset(i, ox, oy, oz);
    const double x = (lx + ox) - px, y = (ly + oy) - py, z = (lz + oz) - pz;
    const double d = std::sqrt(x * x + y * y + z * z), inverse = 1 / d;
    distance[i] = d;
    to.x[i] = x * inverse, to.y[i] = y * inverse, to.z[i] = z * inverse;
  }
}

void aim_at_grid(const LightGrid& grid, const Vec3& p, const GridPlaces& places, int count, RayBatch& to_light,
                 double* distance) {
  const double x1 = grid.a1.x, y1 = grid.a1.y, z1 = grid.a1.z, x2 = grid.a2.x, y2 = grid.a2.y, z2 = grid.a2.z,
               last1 = grid.last1, last2 = grid.last2;
  const double *const us = places.u, *const vs = places.v;
  const auto aim = [&](const auto& offset) { aim_at_offsets(grid.position, p, count, to_light, distance, offset); };
  if (grid.circular) {
    aim([&](int i, double& x, double& y, double& z) {
      const double a = us[i] / last1 - 0.499, b = vs[i] / last2 - 0.499, wide = std::fabs(a), high = std::fabs(b);
      const double s = (wide < high ? high : wide) / std::sqrt(a * a + b * b), u = a * s, v = b * s;
      x = x1 * u + x2 * v, y = y1 * u + y2 * v, z = z1 * u + z2 * v;
    });
  } else {
    aim([&](int i, double& x, double& y, double& z) {
      const double u = us[i] / last1 - 0.5, v = vs[i] / last2 - 0.5;
      x = (0.0 + x1 * u) + x2 * v, y = (0.0 + y1 * u) + y2 * v, z = (0.0 + z1 * u) + z2 * v;
    });
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
  const Vec3& d = f.direction;
  const double low = f.cos_falloff, high = f.cos_radius, limit = f.soft ? high : -HUGE_VAL;
  for (int i = 0; i < end; ++i) {
    const double along = towards.x[i] * d.x + towards.y[i] * d.y + towards.z[i] * d.z,
                 m = distance[i] > 0 ? -along : along;
    const double u = (m - low) / (high - low), smooth = m < low ? 0 : m >= high ? 1 : u * u * (3 - 2 * u);
    const double sharp = raised<kTightness>(m), dimmed = sharp * smooth, bright = m < limit ? dimmed : sharp;
    a[i] = m <= 0 ? 0 : bright;
  }
}

template <int kPower>
void fade(double fade_distance, const double* distance, int end, double* a) {
  for (int i = 0; i < end; ++i) {
    const double faded = a[i] * (2 / (1 + raised<kPower>(distance[i] / fade_distance)));
    a[i] = a[i] == 0 ? 0 : faded;
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
