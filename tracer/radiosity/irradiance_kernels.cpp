#include "tracer/radiosity/irradiance_packet.h"
#include <algorithm>
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

// Eight whole numbers.
HWY_INLINE FloatPacket whole(const std::int16_t* p) {
  constexpr int kVectors = FloatPacket::kVectors;
  const hn::Rebind<std::int16_t, FloatPacket::D> narrow;
  const hn::Rebind<std::int32_t, FloatPacket::D> wide;
  FloatPacket r;
  VERISIM_EACH_VECTOR r.v[i] =
      hn::ConvertTo(FloatPacket::D(), hn::PromoteTo(wide, hn::LoadU(narrow, p + i * FloatPacket::kLanes)));
  return r;
}
// Eight numbers, of upper_half_above().
HWY_INLINE FloatPacket of_upper_halves(const std::uint16_t* p) {
  constexpr int kVectors = FloatPacket::kVectors;
  const hn::Rebind<std::uint16_t, FloatPacket::D> narrow;
  const hn::Rebind<std::uint32_t, FloatPacket::D> wide;
  FloatPacket r;
  VERISIM_EACH_VECTOR r.v[i] = hn::BitCast(
      FloatPacket::D(), hn::ShiftLeft<kLowerBits>(hn::PromoteTo(wide, hn::LoadU(narrow, p + i * FloatPacket::kLanes))));
  return r;
}

// All lengths in the unit of the samples' points.
std::size_t near(const IrradiancePacket* packets, std::size_t count, const IrradianceQuery& query,
                 std::uint32_t* samples) {
  constexpr std::uint32_t kCount = IrradiancePacket::kCount;
  constexpr double kMargin = 1e-5, kTurned = 5e-5;  // the latter of cosines of rounded normals
  const Vec3 point = query.point / query.unit, normal = query.normal / IrradiancePacket::kScale;
  const double farthest =
      std::max({IrradiancePacket::kScale, std::fabs(point.x), std::fabs(point.y), std::fabs(point.z)});
  const FloatPacket px = static_cast<float>(point.x), py = static_cast<float>(point.y),
                    pz = static_cast<float>(point.z);
  const FloatPacket nx = static_cast<float>(normal.x), ny = static_cast<float>(normal.y),
                    nz = static_cast<float>(normal.z);
  const FloatPacket most = static_cast<float>(query.bound * (1.0 + kMargin)),
                    rounding = static_cast<float>(1.7321 + 2e-6 * farthest), one = static_cast<float>(1.0 - kTurned),
                    units = static_cast<float>(1.0 / query.unit);
  std::size_t found = 0;
  for (std::size_t first = 0; first < count; first += kCount) {
    const IrradiancePacket& s = packets[first / kCount];
    const auto along = [&s](int axis) VERISIM_INLINE_LAMBDA { return whole(s.point[axis]); };
    const auto turned = [&s](int axis) VERISIM_INLINE_LAMBDA { return whole(s.normal[axis]); };
    const FloatPacket dx = along(0) - px, dy = along(1) - py, dz = along(2) - pz;
    const FloatPacket reach = of_upper_halves(s.mean_distance) * (units * most) + rounding;
    const FloatPacket squared = dx * dx + dy * dy + dz * dz;
    unsigned met = bits(squared <= reach * reach);
    if (count - first < kCount) met &= (1u << (count - first)) - 1u;
    if (met == 0) continue;
    const FloatPacket turn = one - (turned(0) * nx + turned(1) * ny + turned(2) * nz);
    const FloatPacket left = most - 2.0f * sqrt(max(turn, FloatPacket(0.0f)));
    const FloatPacket within = of_upper_halves(s.widest) * (units * left) + rounding;
    met &= bits((squared <= within * within) & (FloatPacket(0.0f) <= left));
    for (; met != 0; met &= met - 1) samples[found++] = s.sample[std::countr_zero(met)];
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
