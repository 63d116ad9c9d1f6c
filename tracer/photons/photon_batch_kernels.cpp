#include "tracer/photons/photon_batch.h"
#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/photons/photon_batch_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "hwy/highway.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::global {
namespace {
namespace HWY_NAMESPACE {

// Plain loops, which the compiler turns into wide instructions. Conditions are written with & and |, so that nothing
// branches.

void shade_channel(std::size_t end, float pigment, const double* share, const float* intensity, float* energy) {
  for (std::size_t i = 0; i < end; ++i) {
    const float added = static_cast<float>(share[i] * pigment) * (energy[i] * intensity[i]);
    energy[i] = share[i] != 0 ? added : 0.0f;
  }
}

void shade(const PhotonSurface& surface, std::size_t count, PhotonBatch& batch) {
  const Vec3 &n = surface.normal, &g = surface.geometric_normal;
  const double front = surface.front, behind = surface.behind;
  const std::size_t end = (count + 7) / 8 * 8;
  double share[PhotonBatch::kMax];
  float intensity[PhotonBatch::kMax];
  for (std::size_t i = 0; i < end; ++i) {
    const double cosine = n.x * batch.x[i] + n.y * batch.y[i] + n.z * batch.z[i];
    const double slant = g.x * batch.x[i] + g.y * batch.y[i] + g.z * batch.z[i];
    intensity[i] = static_cast<float>(1 / (slant > 0.1 ? slant : 0.1));
    share[i] = (cosine < kEpsilon ? behind : front) * std::fabs(cosine);
  }
  shade_channel(end, surface.pigment.r, share, intensity, batch.r);
  shade_channel(end, surface.pigment.g, share, intensity, batch.g);
  shade_channel(end, surface.pigment.b, share, intensity, batch.b);
}

constexpr PhotonBatchKernels kKernels = {shade};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::global
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::global {
VERISIM_EXPORT_KERNELS(PhotonBatchKernels, photon_batch_kernels)
}  // namespace verisim::global
#endif
