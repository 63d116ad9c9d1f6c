// Four floats at once: SSE where there is SSE (every x86-64), plain code elsewhere. Only what the trees need.
#pragma once

#include <algorithm>
#include <cmath>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace verisim::accel {

#if defined(__SSE2__)

struct Float4 {
  __m128 v;
  Float4() = default;
  Float4(__m128 value) : v(value) {}
  explicit Float4(float all) : v(_mm_set1_ps(all)) {}
  Float4(float a, float b, float c, float d) : v(_mm_setr_ps(a, b, c, d)) {}
  static Float4 load(const float* aligned) { return _mm_load_ps(aligned); }
  void store(float* aligned) const { _mm_store_ps(aligned, v); }
};
inline Float4 operator+(Float4 a, Float4 b) { return _mm_add_ps(a.v, b.v); }
inline Float4 operator-(Float4 a, Float4 b) { return _mm_sub_ps(a.v, b.v); }
inline Float4 operator*(Float4 a, Float4 b) { return _mm_mul_ps(a.v, b.v); }
inline Float4 min(Float4 a, Float4 b) { return _mm_min_ps(a.v, b.v); }
inline Float4 max(Float4 a, Float4 b) { return _mm_max_ps(a.v, b.v); }
inline Float4 sqrt(Float4 a) { return _mm_sqrt_ps(a.v); }
// Lanes in which a <= b; lane i is bit i of bits().
struct Mask4 {
  __m128 v;
  unsigned bits() const { return static_cast<unsigned>(_mm_movemask_ps(v)); }
};
inline Mask4 operator<=(Float4 a, Float4 b) { return {_mm_cmple_ps(a.v, b.v)}; }
inline Mask4 operator&(Mask4 a, Mask4 b) { return {_mm_and_ps(a.v, b.v)}; }
inline Float4 select(Mask4 where, Float4 yes, Float4 no) {
  return _mm_or_ps(_mm_and_ps(where.v, yes.v), _mm_andnot_ps(where.v, no.v));
}

#else

struct Float4 {
  float v[4];
  Float4() = default;
  explicit Float4(float all) : v{all, all, all, all} {}
  Float4(float a, float b, float c, float d) : v{a, b, c, d} {}
  static Float4 load(const float* p) {
    Float4 r;
    std::copy_n(p, 4, r.v);
    return r;
  }
  void store(float* p) const { std::copy_n(v, 4, p); }
};
template <class F>
Float4 lanewise(const Float4& a, const Float4& b, F f) {
  Float4 r;
  for (int i = 0; i < 4; ++i) r.v[i] = f(a.v[i], b.v[i]);
  return r;
}
inline Float4 operator+(Float4 a, Float4 b) {
  return lanewise(a, b, [](float x, float y) { return x + y; });
}
inline Float4 operator-(Float4 a, Float4 b) {
  return lanewise(a, b, [](float x, float y) { return x - y; });
}
inline Float4 operator*(Float4 a, Float4 b) {
  return lanewise(a, b, [](float x, float y) { return x * y; });
}
// As the instructions do: the second operand where the comparison is false.
inline Float4 min(Float4 a, Float4 b) {
  return lanewise(a, b, [](float x, float y) { return x < y ? x : y; });
}
inline Float4 max(Float4 a, Float4 b) {
  return lanewise(a, b, [](float x, float y) { return x > y ? x : y; });
}
inline Float4 sqrt(Float4 a) {
  return lanewise(a, a, [](float x, float) { return std::sqrt(x); });
}
struct Mask4 {
  unsigned lanes;
  unsigned bits() const { return lanes; }
};
inline Mask4 operator<=(Float4 a, Float4 b) {
  unsigned r = 0;
  for (int i = 0; i < 4; ++i) r |= static_cast<unsigned>(a.v[i] <= b.v[i]) << i;
  return {r};
}
inline Mask4 operator&(Mask4 a, Mask4 b) { return {a.lanes & b.lanes}; }
inline Float4 select(Mask4 where, Float4 yes, Float4 no) {
  Float4 r;
  for (int i = 0; i < 4; ++i) r.v[i] = where.lanes >> i & 1 ? yes.v[i] : no.v[i];
  return r;
}

#endif

}  // namespace verisim::accel
