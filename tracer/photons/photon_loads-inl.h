// Photons of a map in packets: their positions, and how far planes that hide them overhang. Included once for each
// target by kernels.
#if defined(VERISIM_PHOTONS_PHOTON_LOADS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VERISIM_PHOTONS_PHOTON_LOADS_INL_H
#undef VERISIM_PHOTONS_PHOTON_LOADS_INL_H
#else
#define VERISIM_PHOTONS_PHOTON_LOADS_INL_H
#endif

#include <bit>
#include <cstdint>
#include <limits>

#include "tracer/photons/photon_kernels.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::global {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

constexpr float kInfiniteFloat = std::numeric_limits<float>::infinity();
using Words = BasicPacket<std::uint32_t, kLanes>;

// Of eight photons that lie one after another. Highway's way takes twice the instructions.
#if HWY_TARGET == HWY_AVX3
HWY_INLINE void load_positions(const PhotonPosition* from, FloatPacket& x, FloatPacket& y, FloatPacket& z) {
  const float* const p = from->data();
  const __m512 low = _mm512_loadu_ps(p), high = _mm512_castps256_ps512(_mm256_loadu_ps(p + 16));
  const auto every_third = [&](int first) {
    const __m512i places = _mm512_add_epi32(_mm512_set1_epi32(first),
                                            _mm512_setr_epi32(0, 3, 6, 9, 12, 15, 18, 21, 0, 0, 0, 0, 0, 0, 0, 0));
    return hn::Vec<FloatPacket::D>{_mm512_castps512_ps256(_mm512_permutex2var_ps(low, places, high))};
  };
  x.v[0] = every_third(0), y.v[0] = every_third(1), z.v[0] = every_third(2);
}
#elif HWY_TARGET == HWY_AVX2
HWY_INLINE void load_positions(const PhotonPosition* from, FloatPacket& x, FloatPacket& y, FloatPacket& z) {
  const float* const p = from->data();
  const __m256 a = _mm256_loadu_ps(p), b = _mm256_loadu_ps(p + 8), c = _mm256_loadu_ps(p + 16);
  // Three and eight have no common divisor, so that all numbers of a coordinate are in different lanes.
  constexpr int k036 = 0b01001001, k147 = 0b10010010, k25 = 0b00100100;
  const __m256i order = _mm256_setr_epi32(0, 3, 6, 1, 4, 7, 2, 5);
  const auto turned = [&](int by) { return _mm256_add_epi32(order, _mm256_set1_epi32(by)); };  // modulo 8
  x.v[0].raw = _mm256_permutevar8x32_ps(_mm256_blend_ps(_mm256_blend_ps(a, b, k147), c, k25), order);
  y.v[0].raw = _mm256_permutevar8x32_ps(_mm256_blend_ps(_mm256_blend_ps(a, b, k25), c, k036), turned(1));
  z.v[0].raw = _mm256_permutevar8x32_ps(_mm256_blend_ps(_mm256_blend_ps(a, b, k036), c, k147), turned(2));
}
#else
HWY_INLINE void load_positions(const PhotonPosition* from, FloatPacket& x, FloatPacket& y, FloatPacket& z) {
  constexpr int kVectors = FloatPacket::kVectors;
  const float* const p = from->data();
  VERISIM_EACH_VECTOR hn::LoadInterleaved3(FloatPacket::D(), p + 3 * i * FloatPacket::kLanes, x.v[i], y.v[i], z.v[i]);
}
#endif

HWY_INLINE FloatPacket overhang_of(const PhotonOverhangs& overhangs, const Words& photons) {
  static_assert(std::endian::native == std::endian::little);
  constexpr int kVectors = Words::kVectors;
  const auto* const levels = reinterpret_cast<const std::uint32_t*>(overhangs.levels.data());
  const hn::RebindToSigned<Words::D> places;
  Words level;
  VERISIM_EACH_VECTOR level.v[i] = hn::GatherOffset(Words::D(), levels, hn::BitCast(places, photons.v[i]));
  level = level & Words(0xffu);
  FloatPacket over;
  const Words bits = shift_left<PhotonOverhangs::kShift>(level + Words(overhangs.base));
  VERISIM_EACH_VECTOR over.v[i] = hn::BitCast(FloatPacket::D(), bits.v[i]);
  return select(level == Words(0u), FloatPacket(-kInfiniteFloat), over);
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::global
HWY_AFTER_NAMESPACE();

#endif
