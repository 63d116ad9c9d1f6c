// The C library's functions as formulas call them that are written once for one number and for lanes: plain calls, or
// lanes at once where library-inl.h has them and the library for the rest. Included once for each target by kernels.
#if defined(VERISIM_FUNCTIONS_LIBRARY_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VERISIM_FUNCTIONS_LIBRARY_LANES_INL_H
#undef VERISIM_FUNCTIONS_LIBRARY_LANES_INL_H
#else
#define VERISIM_FUNCTIONS_LIBRARY_LANES_INL_H
#endif

#include <bit>

#include "tracer/functions/library-inl.h"
#include "tracer/functions/plain_library.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::functions {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

// The lanes `asked`, one by one.
template <LibraryFunction F, int N>
HWY_INLINE void complete(PacketOf<N>& results, const PacketOf<N>& a, const PacketOf<N>& b, unsigned asked) {
  if (asked == 0) return;
  alignas(64) double first[N], second[N], values[N];
  store(first, a), store(second, b), store(values, results);
  for (; asked != 0; asked &= asked - 1) {
    const int k = std::countr_zero(asked);
    values[k] = plain_library<F>(first[k], second[k]);
  }
  results = PacketOf<N>::load(values);
}

#if HWY_NATIVE_FMA
template <int N>
HWY_INLINE Part part_of(const PacketOf<N>& a, int vector) {
  Part r;
  r.v[0] = a.v[vector];
  return r;
}
// What is told of the lanes of one part, as lanes of all.
HWY_INLINE unsigned lanes_of(unsigned told, int vector) { return (told & ((1u << kPart) - 1)) << (vector * kPart); }
#endif

// Of a's lanes, and b's; only those of the bits `asked` are of interest.
template <LibraryFunction F, int N>
HWY_INLINE PacketOf<N> of_library(const PacketOf<N>& a, const PacketOf<N>& b, unsigned asked) {
  PacketOf<N> results = a;
#if HWY_NATIVE_FMA
  using enum LibraryFunction;
  constexpr bool kHyperbolic = F == sinh || F == cosh;
  if (F != atan && (!kHyperbolic || hyperbolic_functions_are_known())) {
    unsigned unsure = 0;
    HWY_UNROLL(8) for (int i = 0; i < PacketOf<N>::kVectors; ++i) {
      const Part first = part_of<N>(a, i), second = part_of<N>(b, i);
      Part values = first;
      unsigned here = 0;
      if constexpr (F == atan2) here = arc<false>(first, second, values);
      if constexpr (F == log) here = logarithm(first, values);
      if constexpr (F == exp) here = exponential(first, values);
      if constexpr (F == sinh) here = hyperbolic_sine(first, values);
      if constexpr (F == cosh) here = hyperbolic_cosine(first, values);
      unsure |= lanes_of(here, i);
      results.v[i] = values.v[0];
    }
    asked &= unsure;
  }
#endif
  complete<F, N>(results, a, b, asked);
  return results;
}
template <int N>
HWY_INLINE SineAndCosine<PacketOf<N>> sine_and_cosine_of_library(const PacketOf<N>& a, unsigned asked) {
  SineAndCosine<PacketOf<N>> results{a, a};
  unsigned unsure_sines = asked, unsure_cosines = asked;
#if HWY_NATIVE_FMA
  unsure_sines = unsure_cosines = 0;
  HWY_UNROLL(8) for (int i = 0; i < PacketOf<N>::kVectors; ++i) {
    const Angle angle = reduced(part_of<N>(a, i));
    Part values;
    unsure_sines |= lanes_of(sine<0>(angle, values), i);
    results.sine.v[i] = values.v[0];
    unsure_cosines |= lanes_of(sine<1>(angle, values), i);
    results.cosine.v[i] = values.v[0];
  }
#endif
  complete<LibraryFunction::sin, N>(results.sine, a, a, asked & unsure_sines);
  complete<LibraryFunction::cos, N>(results.cosine, a, a, asked & unsure_cosines);
  return results;
}

// Called as PlainLibrary is. The calls are not inlined: each is as long as many formulas.
template <int N>
struct LibraryLanes {
  using Value = PacketOf<N>;
  unsigned asked;  // other lanes get anything

  LibraryLanes among(const MaskOf<N>& lanes) const { return {asked & bits(lanes)}; }

#define VERISIM_CALL(name) \
  HWY_NOINLINE Value name(const Value& a) const { return of_library<LibraryFunction::name, N>(a, a, asked); }
  VERISIM_CALL(atan)
  VERISIM_CALL(log)
  VERISIM_CALL(exp)
  VERISIM_CALL(sinh)
  VERISIM_CALL(cosh)
#undef VERISIM_CALL
  HWY_NOINLINE SineAndCosine<Value> sine_and_cosine(const Value& a) const {
    return sine_and_cosine_of_library<N>(a, asked);
  }
  HWY_NOINLINE Value atan2(const Value& y, const Value& x) const {
    return of_library<LibraryFunction::atan2, N>(y, x, asked);
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::functions
HWY_AFTER_NAMESPACE();

#endif
