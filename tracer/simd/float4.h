// Four floats at once, by the compilers' own vectors: SSE on x86, NEON on 64-bit Arm. Only what trees and samples need.
#pragma once

#include <cmath>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace verisim::accel {

struct Float4 {
  using Lanes = float __attribute__((vector_size(16), may_alias));
  Lanes v;
  Float4() = default;
  Float4(Lanes value) : v(value) {}
  explicit Float4(float all) : v{all, all, all, all} {}
  Float4(float a, float b, float c, float d) : v{a, b, c, d} {}
  static Float4 load(const float* aligned) { return *reinterpret_cast<const Lanes*>(aligned); }
  void store(float* aligned) const { *reinterpret_cast<Lanes*>(aligned) = v; }
};
inline Float4 operator+(Float4 a, Float4 b) { return a.v + b.v; }
inline Float4 operator-(Float4 a, Float4 b) { return a.v - b.v; }
inline Float4 operator*(Float4 a, Float4 b) { return a.v * b.v; }

// Of each lane all bits or none.
struct Mask4 {
  using Lanes = std::int32_t __attribute__((vector_size(16)));
  Lanes v;
  unsigned bits() const;  // lane i is bit i
};
inline Mask4 operator<=(Float4 a, Float4 b) { return {a.v <= b.v}; }
inline Mask4 operator&(Mask4 a, Mask4 b) { return {a.v & b.v}; }
inline Float4 select(Mask4 where, Float4 yes, Float4 no) { return where.v ? yes.v : no.v; }

// min and max: the second operand where the comparison is false. On x86 instructions of their own, which GCC 12 does
// not find for constants, nor for roots that might set errno.
#if defined(__SSE2__)
inline Float4 min(Float4 a, Float4 b) { return _mm_min_ps(a.v, b.v); }
inline Float4 max(Float4 a, Float4 b) { return _mm_max_ps(a.v, b.v); }
inline Float4 sqrt(Float4 a) { return _mm_sqrt_ps(a.v); }
inline unsigned Mask4::bits() const { return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(v))); }
#else
inline Float4 min(Float4 a, Float4 b) { return a.v < b.v ? a.v : b.v; }
inline Float4 max(Float4 a, Float4 b) { return a.v > b.v ? a.v : b.v; }
inline Float4 sqrt(Float4 a) {
  for (int i = 0; i < 4; ++i) a.v[i] = std::sqrt(a.v[i]);
  return a;
}
inline unsigned Mask4::bits() const {
  const Lanes bit = v & Lanes{1, 2, 4, 8};
  return static_cast<unsigned>(bit[0] | bit[1] | bit[2] | bit[3]);
}
#endif

}  // namespace verisim::accel
