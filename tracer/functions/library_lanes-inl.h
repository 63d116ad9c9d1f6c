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

// Of a's lanes, and b's; only those of the bits `asked` are of interest.
template <LibraryFunction F, int N>
PacketOf<N> of_library(const PacketOf<N>& a, const PacketOf<N>& b, unsigned asked) {
  PacketOf<N> result = a;
#if HWY_NATIVE_FMA
  using enum LibraryFunction;
  constexpr bool kHyperbolic = F == sinh || F == cosh;
  if (F != atan && (!kHyperbolic || hyperbolic_functions_are_known())) {
    unsigned unsure = 0;
    HWY_UNROLL(8) for (int i = 0; i < PacketOf<N>::kVectors; ++i) {
      Part first, second, values = Part(0.0);
      first.v[0] = a.v[i], second.v[0] = b.v[i];
      unsigned here = 0;
      if constexpr (F == sin || F == cos) here = sine<F == cos>(first, values);
      if constexpr (F == atan2) here = arc<false>(first, second, values);
      if constexpr (F == log) here = logarithm(first, values);
      if constexpr (F == exp) here = exponential(first, values);
      if constexpr (F == sinh) here = hyperbolic_sine(first, values);
      if constexpr (F == cosh) here = hyperbolic_cosine(first, values);
      unsure |= (here & ((1u << kPart) - 1)) << (i * kPart);
      result.v[i] = values.v[0];
    }
    asked &= unsure;
  }
#endif
  if (asked == 0) return result;
  alignas(64) double first[N], second[N], values[N];
  store(first, a), store(second, b), store(values, result);
  for (; asked != 0; asked &= asked - 1) {
    const int k = std::countr_zero(asked);
    values[k] = plain_library<F>(first[k], second[k]);
  }
  return PacketOf<N>::load(values);
}

// Called as PlainLibrary is.
template <int N>
struct LibraryLanes {
  using Value = PacketOf<N>;
  unsigned asked;  // other lanes get anything

  LibraryLanes among(const MaskOf<N>& lanes) const { return {asked & bits(lanes)}; }

#define VERISIM_CALL(name) \
  HWY_INLINE Value name(const Value& a) const { return of_library<LibraryFunction::name, N>(a, a, asked); }
  VERISIM_CALL(sin)
  VERISIM_CALL(cos)
  VERISIM_CALL(atan)
  VERISIM_CALL(log)
  VERISIM_CALL(exp)
  VERISIM_CALL(sinh)
  VERISIM_CALL(cosh)
#undef VERISIM_CALL
  HWY_INLINE Value atan2(const Value& y, const Value& x) const {
    return of_library<LibraryFunction::atan2, N>(y, x, asked);
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::functions
HWY_AFTER_NAMESPACE();

#endif
