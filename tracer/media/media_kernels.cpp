#include "tracer/media/media_kernels.h"
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/media/media_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "hwy/highway.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::global {
namespace {
namespace HWY_NAMESPACE {

// Plain loops, which the compiler turns into wide instructions. Conditions are written with & and |, so that nothing
// branches.

constexpr int rounded(int count) { return (count + MediaPacket::kStep - 1) / MediaPacket::kStep * MediaPacket::kStep; }

// phase() of every lane.
template <class Function>
void add_each(int count, MediaPacket& packet, Function&& phase) {
  const auto& to = packet.to_light.direction;
  const int end = rounded(count);
  for (int i = 0; i < end; ++i)
    packet.phase[i] += phase(to.x[i] * packet.view.x[i] + to.y[i] * packet.view.y[i] + to.z[i] * packet.view.z[i]);
}

void add_phase(const scene::Media& media, int count, MediaPacket& packet) {
  switch (media.scattering_type) {
    case 2:
      return add_each(count, packet, [](double cosine) {
        const double half = 0.5 * (1.0 + cosine), h2 = half * half, h4 = h2 * h2;
        return 0.576655375 * (1.0 + 9.0 * h4 * h4);
      });
    case 3:
      return add_each(count, packet, [](double cosine) {
        const double half = 0.5 * (1.0 + cosine), h2 = half * half, h4 = h2 * h2, h8 = h4 * h4, h16 = h8 * h8;
        return 0.495714547 * (1.0 + 50.0 * h16 * h16);
      });
    case 4:
      return add_each(count, packet, [](double cosine) { return 0.799372013 * (1.0 + cosine * cosine); });
    case 5: {
      const double e = media.eccentricity;
      return add_each(count, packet, [e](double cosine) {
        const double d = 1.0 + e * e - 2.0 * e * cosine;
        return (1.0 - e * e) / (d * std::sqrt(d));
      });
    }
    default:
      return add_each(count, packet, [](double) { return 1.0; });
  }
}

void scatter_channel(int end, const double* phase, const float* scattering, const float* arriving, float* to) {
  for (int i = 0; i < end; ++i) to[i] = static_cast<float>(scattering[i] * phase[i]) * arriving[i];
}

void scatter(int media, int count, MediaPacket& packet) {
  double phase[MediaPacket::kSize];
  const double divisor = media;
  const int end = rounded(count);
  for (int i = 0; i < end; ++i) phase[i] = packet.phase[i] / divisor;
  scatter_channel(end, phase, packet.scattering.r, packet.arriving.r, packet.scattered.r);
  scatter_channel(end, phase, packet.scattering.g, packet.arriving.g, packet.scattered.g);
  scatter_channel(end, phase, packet.scattering.b, packet.arriving.b, packet.scattered.b);
}

constexpr MediaKernels kKernels = {add_phase, scatter};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::global
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::global {
VERISIM_EXPORT_KERNELS(MediaKernels, media_kernels)
}  // namespace verisim::global
#endif
