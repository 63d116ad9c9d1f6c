#include "tracer/photons/photon_row.h"
#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/photons/photon_row_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "hwy/highway.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::global {
namespace {
namespace HWY_NAMESPACE {

// Plain loops, which the compiler turns into wide instructions. Conditions are written with & and |, so that nothing
// branches.

void shade_channel(std::size_t end, float pigment, const float* share, const float* intensity, float* energy) {
  for (std::size_t i = 0; i < end; ++i) {
    const float added = share[i] * pigment * (energy[i] * intensity[i]);
    energy[i] = share[i] != 0.0f ? added : 0.0f;
  }
}

void shade(const PhotonSurface& surface, std::size_t count, PhotonRow& row) {
  const Vec3 &n = surface.normal, &raw = surface.raw;
  const double front = surface.front, behind = surface.behind, per_area = surface.per_area;
  const std::size_t end = (count + 7) / 8 * 8;
  float share[PhotonRow::kMost], intensity[PhotonRow::kMost];
  for (std::size_t i = 0; i < end; ++i) {
    const double cosine = n.x * row.x[i] + n.y * row.y[i] + n.z * row.z[i];
    const double slant = raw.x * row.x[i] + raw.y * row.y[i] + raw.z * row.z[i];
    intensity[i] = static_cast<float>(per_area / (slant > 0.1 ? slant : 0.1));
    share[i] = static_cast<float>((cosine < kEpsilon ? behind : front) * std::fabs(cosine));
  }
  shade_channel(end, surface.pigment.r, share, intensity, row.r);
  shade_channel(end, surface.pigment.g, share, intensity, row.g);
  shade_channel(end, surface.pigment.b, share, intensity, row.b);
}

constexpr PhotonRowKernels kKernels = {shade};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::global
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::global {
VERISIM_EXPORT_KERNELS(PhotonRowKernels, photon_row_kernels)
}  // namespace verisim::global
#endif
