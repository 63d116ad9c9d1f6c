#include "tracer/radiosity/irradiance_packet.h"
#include <bit>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/radiosity/irradiance_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::global {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

std::size_t near(const IrradiancePacket* packet, std::size_t count, const IrradianceQuery& query,
                 std::uint32_t* samples) {
  constexpr double kMargin = 1e-5;
  constexpr std::uint32_t kCount = IrradiancePacket::kCount;
  const auto px = static_cast<float>(query.point.x), py = static_cast<float>(query.point.y),
             pz = static_cast<float>(query.point.z);
  const auto nx = static_cast<float>(query.normal.x), ny = static_cast<float>(query.normal.y),
             nz = static_cast<float>(query.normal.z);
  const auto most = static_cast<float>(query.bound * (1.0 + kMargin)),
             rounding = static_cast<float>(2e-6 * query.farthest), one = static_cast<float>(1.0 - kMargin);
  std::size_t found = 0;
  for (const IrradiancePacket* s = packet; s != packet + count; ++s) {
    alignas(32) float near[kCount];  // 1: yes
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const float dx = s->point[0][i] - px, dy = s->point[1][i] - py, dz = s->point[2][i] - pz;
      const float reach = s->mean_distance[i] * most + rounding;
      const float turn = one - (s->normal[0][i] * nx + s->normal[1][i] * ny + s->normal[2][i] * nz);
      const float left = most - 2.0f * std::sqrt(turn > 0.0f ? turn : 0.0f);
      const float within = s->widest[i] * left, widest = (within > 0.0f ? within : 0.0f) + rounding;
      const float squared = dx * dx + dy * dy + dz * dz;
      near[i] = ((squared <= reach * reach) & (squared <= widest * widest) & (0.0f <= left)) ? 1.0f : 0.0f;
    }
    for (unsigned met = bits(FloatPacket::load(near) > 0.0f); met != 0; met &= met - 1)
      samples[found++] = s->sample[std::countr_zero(met)];
  }
  return found;
}

constexpr IrradianceKernels kKernels = {near};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::global
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::global {
VERISIM_EXPORT_KERNELS(IrradianceKernels, irradiance_kernels)
}  // namespace verisim::global
#endif
