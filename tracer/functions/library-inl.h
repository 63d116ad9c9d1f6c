// sin, cos, atan2, ln, exp, powers, sinh and cosh of several numbers, with the bits of the C library. All but the last
// two are computed as a sum hi + lo that is much more precise than a double; where the library's own error could make
// it round to the other neighbour, the lane is left to the library. So it does not matter that products are fused here.
// Included once for each target by kernels, which use it on targets that fuse; without, this is no faster than the
// library.
#if defined(VERISIM_FUNCTIONS_LIBRARY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VERISIM_FUNCTIONS_LIBRARY_INL_H
#undef VERISIM_FUNCTIONS_LIBRARY_INL_H
#else
#define VERISIM_FUNCTIONS_LIBRARY_INL_H
#endif

#include <bit>
#include <cmath>
#include <cstdint>

#include "tracer/functions/library_tables.h"
#include "tracer/simd/packet-inl.h"

#if HWY_NATIVE_FMA
HWY_BEFORE_NAMESPACE();
namespace verisim::functions {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

// The library's results are within 1/2 + this many units in the last place (the largest known error of glibc 2.28 and
// later is 0.516 for sine and cosine and 0.524 for atan2, 0.519 for log, and 0.514 for the powers that are computed
// here; the sums here add less than 0.012, 0.002, 0.006 and, for x^y, 0.001 + |y| / 2000).
constexpr double kSineError = 0.03, kArcError = 0.03, kLogarithmError = 0.03, kPowerError = 0.02;
// That of exp is 0.511, and the sum here adds less than 0.001.
constexpr double kExponentialError = 0.02;

// As many numbers as a register holds, so that all that is known of them stays in registers.
constexpr int kPart = Packet::kLanes;
using Part = PacketOf<kPart>;
using PartMask = MaskOf<kPart>;
using PartInts = IntPacketOf<kPart>;
// a b + c and a b - c, fused.
HWY_INLINE Part multiply_add(const Part& a, const Part& b, const Part& c) {
  Part r;
  r.v[0] = hn::MulAdd(a.v[0], b.v[0], c.v[0]);
  return r;
}
HWY_INLINE Part multiply_subtract(const Part& a, const Part& b, const Part& c) {
  Part r;
  r.v[0] = hn::MulSub(a.v[0], b.v[0], c.v[0]);
  return r;
}
// Of a table of 16, by the lowest bits of the index.
HWY_INLINE Part entry(const double* table, const PartInts& index) {
#if HWY_TARGET == HWY_AVX3
  Part r;  // Highway 1.0.3 has no lookup in two registers
  r.v[0].raw = _mm512_permutex2var_pd(_mm512_load_pd(table), index.v[0].raw, _mm512_load_pd(table + 8));
  return r;
#else
  return gather(table, index & PartInts(15));
#endif
}
HWY_INLINE Part with_sign(const Part& v, const PartMask& negative) { return select(negative, -v, v); }

struct Two {
  Part hi, lo;
};
// hi + lo is a + b; |a| >= |b| or a == 0.
HWY_INLINE Two sum_of(const Part& a, const Part& b) {
  const Part s = a + b;
  return {s, b - (s - a)};
}
// The same for any order.
HWY_INLINE Two any_sum_of(const Part& a, const Part& b) {
  const Part s = a + b, v = s - a;
  return {s, (a - (s - v)) + (b - v)};
}
HWY_INLINE Two product_of(const Part& a, const Part& b) {
  const Part p = a * b;
  return {p, multiply_subtract(a, b, p)};
}
// hi + lo rounded, and whether all numbers near it round to the same.
HWY_INLINE PartMask rounds_surely(const Part& hi, const Part& lo, const Part& error, Part& result) {
  result = hi + lo;
  const Part power_of_two = number_of(bits_of(result) & PartInts(0x7ff0000000000000)),
             margin = power_of_two * (error * 0x1p-52);
  return hi + (lo - margin) == hi + (lo + margin);
}

constexpr double kRound = 0x1.8p52;  // what is added to it and taken away again is rounded to an integer

// What sine and cosine of an angle x have in common: x - n pi/16 as r + rl, sin r - r and cos r - 1.
struct Angle {
  Part x, r, rl, sine_part, cosine_part;
  PartInts turn;  // n, in the lowest bits
  PartMask known;
};
HWY_INLINE Angle reduced(const Part& given) {
  // pi/16 in parts: products of the first two with integers below 2^20 are exact.
  constexpr double kPart1 = 0x1.921fb544p-3, kPart2 = 0x1.0b4611a6p-37, kPart3 = 0x1.3198a2e037073p-72;
  const PartMask small = abs(given) < 0x1p17;
  const Part x = select(small, given, Part(0.0));
  const Part shifted = x * 0x1.45f306dc9c883p2 + kRound, n = shifted - kRound;
  // The first difference is exact.
  const Two first = any_sum_of(x - n * kPart1, -(n * kPart2));
  const Two rest = sum_of(first.hi, first.lo - n * kPart3);
  const Part r = rest.hi, z = r * r, z2 = z * z;
  const PartMask cancelled = (n != 0.0) & (abs(r) < 0x1p-20);
  const Part sine_high = multiply_add(Part(-1 / 39916800.0), z, Part(1 / 362880.0)),
             sine_middle = multiply_add(Part(-1 / 5040.0), z, Part(1 / 120.0));
  const Part sine_part = multiply_add(multiply_add(sine_high, z2, sine_middle), z, Part(-1 / 6.0)) * (r * z);
  const Part cosine_high = multiply_add(Part(-1 / 3628800.0), z, Part(1 / 40320.0)),
             cosine_middle = multiply_add(Part(-1 / 720.0), z, Part(1 / 24.0));
  const Part cosine_part = multiply_add(multiply_add(cosine_high, z2, cosine_middle), z, Part(-1 / 2.0)) * z;
  return {x, r, rest.lo, sine_part, cosine_part, bits_of(shifted), small & ~cancelled};
}
// sin (quarter 0) or cos (quarter 1); the lanes that are not sure.
template <int quarter>
HWY_INLINE unsigned sine(const Angle& angle, Part& sines) {
  const PartInts turn = angle.turn + PartInts(8 * quarter);
  // s cos r + c sin r = s + (c r + ...), s and c from the table.
  const Part s = entry(functions::kSineOf16ths, turn), s_lo = entry(functions::kSineOf16thsLow, turn);
  const PartMask opposite = (turn & PartInts(8)) != PartInts(0);
  const Part c = with_sign(entry(functions::kSineOf16ths, turn + PartInts(8)), opposite),
             c_lo = with_sign(entry(functions::kSineOf16thsLow, turn + PartInts(8)), opposite);
  const Two linear = product_of(c, angle.r), sum = sum_of(s, linear.hi);
  const Part small_parts = multiply_add(c, angle.rl, multiply_add(c_lo, angle.r, s_lo));
  Part result;
  const PartMask sure = rounds_surely(
      sum.hi, sum.lo + (linear.lo + multiply_add(c, angle.sine_part, multiply_add(s, angle.cosine_part, small_parts))),
      kSineError, result);
  const Part turned = with_sign(result, (turn & PartInts(16)) != PartInts(0));
  sines = quarter == 0 ? select(angle.x == 0.0, angle.x, turned) : turned;  // the sign of zero
  return bits(~(sure & angle.known));
}

// Nearly: within a unit in the last place is good enough.
template <bool Nearly>
HWY_INLINE unsigned arc(const Part& y, const Part& x, Part& angles) {
  const Part ax = abs(x), ay = abs(y);
  const PartMask steep = ay > ax;
  const Part longer = select(steep, ay, ax), shorter = select(steep, ax, ay);
  // On the axes, too, where real numbers lie.
  const PartMask usual = (longer < 0x1p300) & ((shorter > 0x1p-300) | (shorter == 0.0));
  const Part d = select(usual & (longer > 0x1p-300), longer, Part(1.0)), n = select(usual, shorter, Part(0.0));
  // atan(n / d) = atan c + atan u, u = (n - c d) / (d + c n), c the nearest 64th.
  const Part shifted = n / d * 64.0 + kRound, c = (shifted - kRound) * (1.0 / 64);
  const PartInts place = bits_of(shifted) - bits_of(Part(kRound));
  const Two cd = product_of(c, d), cn = product_of(c, n), over = any_sum_of(n - cd.hi, -cd.lo);
  Two under = sum_of(d, cn.hi);
  under.lo += cn.lo;
  const Part inverse = 1.0 / under.hi, u = over.hi * inverse;
  const Two back = product_of(u, under.hi);
  const Part ul = (((over.hi - back.hi) - back.lo) + (over.lo - u * under.lo)) * inverse;
  const Part z = u * u, cubic = (u * z) * multiply_add(z * z, multiply_add(z, Part(1.0 / 9), Part(-1.0 / 7)),
                                                       multiply_add(z, Part(1.0 / 5), Part(-1.0 / 3)));
  const PartInts pair = place + place;
  const Part known = gather(&functions::kArcOf64ths[0].hi, pair),
             known_lo = gather(&functions::kArcOf64ths[0].hi, pair + PartInts(1));
  const Two acute = sum_of(known, u);
  const Part acute_lo = acute.lo + (known_lo + (ul + cubic));
  // By octant: base + acute or base - acute.
  const PartMask left = bits_of(x) < PartInts(0), minus = steep ^ left;
  const Part base = select(steep, Part(0x1.921fb54442d18p0), select(left, Part(0x1.921fb54442d18p1), Part(0.0)));
  const Part base_lo = select(steep, Part(0x1.1a62633145c07p-54), select(left, Part(0x1.1a62633145c07p-53), Part(0.0)));
  const Two sum = sum_of(base, with_sign(acute.hi, minus));
  Part result;
  const PartMask sure = rounds_surely(sum.hi, sum.lo + (base_lo + with_sign(acute_lo, minus)), kArcError, result);
  angles = with_sign(result, bits_of(y) < PartInts(0));
  return bits(Nearly ? ~usual : ~(usual & sure));
}

// Where logarithms are computed.
HWY_INLINE PartMask usual(const Part& x) { return (x > 0x1p-1000) & (x < 0x1p1000); }

// ln x to about 2^-65, or better where it is small; x is usual.
HWY_INLINE Two logarithm_of(const Part& x) {
  constexpr double kLn2 = 0x1.62e42fefa3800p-1,
                   kLn2Low = 0x1.ef35793c76730p-45;  // the product of the first with an exponent is exact
  // x = 2^e m with m from 11/16 to 11/8.
  const PartInts exponent = shift_right<52>(bits_of(x) - PartInts(0x3fe6000000000000)),
                 place = bits_of(x) - shift_left<52>(exponent);
  const Part e = number_of(exponent + PartInts(std::bit_cast<std::int64_t>(kRound))) - kRound, m = number_of(place);
  // c m = 1 + r + rl: ln x = e ln 2 - ln c + ln(1 + r + rl), where c is 1 and e is 0 near 1.
  const PartInts index = shift_right<48>(place);
  const Two scaled = product_of(entry(functions::kReciprocals, index), m);
  const Part r = scaled.hi - 1.0, rl = scaled.lo;
  const Two square = product_of(r, r);
  const Part z = square.hi, z2 = z * z, z4 = z2 * z2;
  const auto pair = [&](double low, double high)
                        VERISIM_INLINE_LAMBDA { return multiply_add(Part(high), r, Part(low)); };
  const Part low = multiply_add(pair(1.0 / 5, -1.0 / 6), z, pair(1.0 / 3, -1.0 / 4)),
             middle = multiply_add(pair(1.0 / 9, -1.0 / 10), z, pair(1.0 / 7, -1.0 / 8)),
             high = multiply_add(pair(1.0 / 13, -1.0 / 14), z, pair(1.0 / 11, -1.0 / 12)),
             last = pair(1.0 / 15, -1.0 / 16);
  const Part cubic = multiply_add(multiply_add(last, z2, high), z4, multiply_add(middle, z2, low)) * (z * r);
  const Two one_plus = sum_of(r, z * -0.5);
  const Part one_plus_lo = one_plus.lo + (cubic + multiply_add(square.lo, Part(-0.5), multiply_add(rl, -r, rl)));
  const Two known = sum_of(e * kLn2, entry(functions::kLogarithms, index)), sum = sum_of(known.hi, one_plus.hi);
  return {sum.hi, sum.lo + (known.lo +
                            (multiply_add(e, Part(kLn2Low), entry(functions::kLogarithmsLow, index)) + one_plus_lo))};
}

HWY_INLINE unsigned logarithm(const Part& given, Part& logarithms) {
  const PartMask known = usual(given);
  const Two sum = logarithm_of(select(known, given, Part(1.0)));
  const PartMask sure = rounds_surely(sum.hi, sum.lo, kLogarithmError, logarithms);
  return bits(~(known & sure));
}

// e^(hi + lo), of a size below 700, and whether it rounds surely.
HWY_INLINE PartMask exponential_of(const Two& t, const Part& error, Part& exponentials) {
  // ln 2 / 16 in parts: products of the first with integers below 2^16 are exact.
  constexpr double kPart1 = 0x1.62e42fefa0000p-5, kPart2 = 0x1.cf79abc9e3b3ap-44;
  const Part shifted = t.hi * 0x1.71547652b82fep+4 + kRound, n = shifted - kRound;
  const PartInts turn = bits_of(shifted) - bits_of(Part(kRound));
  // e^t = 2^(n / 16) e^r; the first difference is exact.
  const Two r = any_sum_of(t.hi - n * kPart1, t.lo - n * kPart2);
  const auto pair = [&](double low, double high)
                        VERISIM_INLINE_LAMBDA { return multiply_add(Part(high), r.hi, Part(low)); };
  const Part z = r.hi * r.hi;
  const Part rest =
      multiply_add(multiply_add(multiply_add(pair(1.0 / 5040, 1.0 / 40320), z, pair(1.0 / 120, 1.0 / 720)), z,
                                pair(1.0 / 6, 1.0 / 24)),
                   z * r.hi, multiply_add(z, Part(0.5), r.lo));
  // s e^r = s + (s r + ...), s from the table.
  const Part s = entry(functions::kPowersOf2, turn), s_lo = entry(functions::kPowersOf2Low, turn);
  const Two linear = product_of(s, r.hi), sum = sum_of(s, linear.hi);
  Part result;
  const PartMask sure = rounds_surely(
      sum.hi, sum.lo + (linear.lo + multiply_add(s, rest, multiply_add(s_lo, r.hi, s_lo))), error, result);
  exponentials = number_of(bits_of(result) + shift_left<52>(shift_right<4>(turn)));
  return sure;
}

HWY_INLINE unsigned exponential(const Part& given, Part& exponentials) {
  const PartMask known = abs(given) < 700.0;
  return bits(~(known & exponential_of({select(known, given, Part(0.0)), Part(0.0)}, kExponentialError, exponentials)));
}

// x^y where |y ln x| is below 64.
HWY_INLINE unsigned power(const Part& given, const Part& y, Part& powers) {
  const Part x = select(usual(given), given, Part(1.0));
  const Two logarithm = logarithm_of(x);
  Two t = product_of(y, logarithm.hi);
  const PartMask known = usual(given) & (abs(y) < 64.0) & (abs(t.hi) < 64.0);
  t.hi = select(known, t.hi, Part(0.0)), t.lo = select(known, multiply_add(y, logarithm.lo, t.lo), Part(0.0));
  return bits(~(known & exponential_of(t, kPowerError + abs(y) * (1.0 / 1024), powers)));
}

// sinh and cosh are not precise enough in the library for that: their errors are those of certain sequences of
// operations, which are followed here. They come from fdlibm (e_sinh.c, e_cosh.c, s_expm1.c), on which most libraries
// build, with its constants:
//
//   Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
//   Developed at SunPro, a Sun Microsystems, Inc. business.
//   Permission to use, copy, modify, and distribute this software is freely granted, provided that this notice is
//   preserved.
//
// Which products are fused, and in which order the polynomial is summed, was found by trial with glibc 2.36 on an x86
// processor that fuses. Others differ: hyperbolic_functions_are_known() tells whether this is the library at hand.
constexpr double kHyperbolicEnd = 22;      // sizes beyond which the library takes other ways
constexpr double kHalfLn2 = 0x1.62e43p-2;  // above it, to 20 bits, as fdlibm compares
constexpr double kThreeHalfLn2 = 0x1.0a2b2p0;

// e^x - 1, 0 <= x <= 22.
HWY_INLINE Part exponential_less_one(const Part& given) {
  constexpr double kLn2High = 6.93147180369123816490e-01, kLn2Low = 1.90821492927058770002e-10,
                   kPerLn2 = 1.44269504088896338700e+00;
  constexpr double kQ1 = -3.33333333333331316428e-02, kQ2 = 1.58730158725481460165e-03,
                   kQ3 = -7.93650757867487942473e-05, kQ4 = 4.00821782732936239552e-06,
                   kQ5 = -2.01099218183624371326e-07;
  // x = k ln 2 + r, and r is rounded off by c.
  const PartMask none = given < kHalfLn2;
  const Part k =
      select(none, Part(0.0), select(given < kThreeHalfLn2, Part(1.0), trunc(multiply_add(kPerLn2, given, Part(0.5)))));
  const Part high = given - k * kLn2High, low = k * kLn2Low, r = high - low, c = (high - r) - low;
  const Part half = r * 0.5, s = r * half, s2 = s * s;
  const Part quotient =
      multiply_add(s2 * s2, multiply_add(s, Part(kQ5), Part(kQ4)),
                   multiply_add(s2, multiply_add(s, Part(kQ3), Part(kQ2)), multiply_add(s, Part(kQ1), Part(1.0))));
  const Part t = multiply_add(-quotient, half, Part(3.0)), e = s * ((quotient - t) / multiply_add(-r, t, Part(6.0)));
  const Part rest = select(none, multiply_subtract(r, e, s), multiply_subtract(r, e - c, c) - s);
  const PartInts exponent = shift_left<52>(bits_of(k + kRound));
  const Part up = number_of(PartInts(0x3ff0000000000000) + exponent),
             down = number_of(PartInts(0x3ff0000000000000) - exponent);
  const Part twice = select(r < -0.25, (rest - (r + 0.5)) * -2.0, 1.0 + (r - rest) * 2.0),
             more = select(k < 20.0, (1.0 - down) - (rest - r), (r - (rest + down)) + 1.0) * up;
  return select(none, r - rest, select(k == 1.0, twice, more));
}

HWY_INLINE unsigned hyperbolic_sine(const Part& given, Part& sines) {
  const Part size = abs(given);
  const PartMask known = size < kHyperbolicEnd, below1 = size < 1.0;
  const Part t = exponential_less_one(select(known, size, Part(0.0))), h = with_sign(Part(0.5), given < 0.0);
  const Part quotient = select(below1, t * t, t) / (t + 1.0);
  sines = select(size < 0x1p-28, given, select(below1, t * 2.0 - quotient, t + quotient) * h);
  return bits(~known);
}

HWY_INLINE unsigned hyperbolic_cosine(const Part& given, Part& cosines) {
  const Part size = abs(given);
  const PartMask known = size < kHyperbolicEnd, near = size < kHalfLn2;
  Part e;
  const PartMask sure = exponential_of({select(known, size, Part(0.0)), Part(0.0)}, kExponentialError, e);
  cosines = e * 0.5 + 0.5 / e;
  if (any(near)) {
    const Part t = exponential_less_one(select(near, size, Part(0.0))), w = t + 1.0;
    cosines = select(near, (t * t) / (w + w) + 1.0, cosines);
  }
  return bits(~(known & (near | sure)));
}

// Whether they have the library's bits, by arguments that tell its ways apart and by some over the whole range.
HWY_INLINE bool hyperbolic_functions_are_known() {
  static const bool known = []() HWY_ATTR {
    constexpr int kSpread = 512;
    for (int n = 0; n < functions::kTellingArguments + kSpread; n += kPart) {
      alignas(64) double arguments[kPart], sines[kPart], cosines[kPart];
      for (int k = 0; k < kPart; ++k)
        arguments[k] = n < functions::kTellingArguments
                           ? functions::kTelling[n + k]
                           : (n + k) * (kHyperbolicEnd / (functions::kTellingArguments + kSpread));
      Part sine, cosine;
      unsigned unsure = hyperbolic_sine(Part::load(arguments), sine);
      unsure |= hyperbolic_cosine(Part::load(arguments), cosine);
      store(sines, sine), store(cosines, cosine);
      for (int k = 0; k < kPart; ++k)
        if ((unsure >> k & 1) == 0 && (sines[k] != std::sinh(arguments[k]) || cosines[k] != std::cosh(arguments[k])))
          return false;
    }
    return true;
  }();
  return known;
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::functions
HWY_AFTER_NAMESPACE();
#endif  // HWY_NATIVE_FMA

#endif
