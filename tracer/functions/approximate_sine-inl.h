// Sines and cosines of eight numbers up to kMaxApproximate, within kApproximateError: where the last bits do not matter
// this is faster than the C library's. Included once for each target by kernels.
#if defined(VERISIM_FUNCTIONS_NEAR_SINE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VERISIM_FUNCTIONS_NEAR_SINE_INL_H
#undef VERISIM_FUNCTIONS_NEAR_SINE_INL_H
#else
#define VERISIM_FUNCTIONS_NEAR_SINE_INL_H
#endif

#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::functions {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

HWY_INLINE Packet approximate_sum(const Packet& a, const Packet& b, const Packet& c) {  // a b + c
#if HWY_TARGET == HWY_AVX3
  constexpr int kVectors = Packet::kVectors;
  Packet r;
  VERISIM_EACH_VECTOR r.v[i] = hn::MulAdd(a.v[i], b.v[i], c.v[i]);
  return r;
#else
  return a * b + c;
#endif
}

template <bool cosine>
HWY_INLINE Packet approximate_sine(const Packet& x) {
  constexpr double kShift = 0x1.8p52, kInverse = 0.31830988618379067154;
  // pi in parts: products of the first two with halves of integers below 2^17 are exact.
  constexpr double kPart1 = 0x1.921fb544p1, kPart2 = 0x1.0b4611a6p-33, kPart3 = 0x1.3198a2e037073p-68;
  const Packet shifted = (cosine ? x * kInverse + 0.5 : x * kInverse) + kShift, whole = shifted - kShift,
               turns = cosine ? whole - 0.5 : whole;
  const Packet r = ((x - turns * kPart1) - turns * kPart2) - turns * kPart3, z = r * r, z2 = z * z, z4 = z2 * z2;
  const auto pair = [&](double low, double high)
                        VERISIM_INLINE_LAMBDA { return approximate_sum(Packet(high), z, Packet(low)); };
  // (sin r - r) / r^3 by Taylor, to r^21 / 21!.
  const Packet first = approximate_sum(pair(-1.0 / 5040, 1.0 / 362880), z2, pair(-1.0 / 6, 1.0 / 120));
  const Packet second = approximate_sum(pair(-1.0 / 1307674368000.0, 1.0 / 355687428096000.0), z2,
                                        pair(-1.0 / 39916800, 1.0 / 6227020800.0));
  const Packet third = pair(-1.0 / 121645100408832000.0, 1.0 / 51090942171709440000.0);
  const Packet sine = approximate_sum(approximate_sum(approximate_sum(third, z4, second), z4, first), r * z, r);
  return number_of(bits_of(sine) ^ shift_left<63>(bits_of(shifted)));
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::functions
HWY_AFTER_NAMESPACE();

#endif
