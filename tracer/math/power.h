// Powers in plain operations without branches, which compilers turn into wide instructions within the loops of kernels.
#pragma once

#include <bit>
#include <cstdint>

namespace verisim::power {

inline constexpr double kLn2High = 0x1.62e42fefa3800p-1,
                        kLn2Low = 0x1.ef35793c76730p-45;  // the product of the first with a small integer is exact
inline constexpr double kShift = 0x1.8p52;                // what is added to it loses its fraction

// The natural logarithm of a normal number above 0: with kTerms = 10 to about 1e-16, with 11 to the last bits.
template <int kTerms>
__attribute__((always_inline)) inline double logarithm(double x) {
  static_assert(kTerms == 10 || kTerms == 11);
  // x = 2^e f with f between the roots of 1/2 and 2; log f = 2 atanh s.
  const auto bits = std::bit_cast<std::int64_t>(x);
  const std::int64_t e = (bits - 0x3fe6a09e667f3bcd) >> 52;
  const double f = std::bit_cast<double>(bits - (e << 52));
  const double n = std::bit_cast<double>(e + std::bit_cast<std::int64_t>(kShift)) - kShift;
  const double s = (f - 1) / (f + 1), z = s * s;
  double a = 1.0 / 21;
  if constexpr (kTerms == 11) a = 1.0 / 23 * z + 1.0 / 21;
  a = a * z + 1.0 / 19;
  a = a * z + 1.0 / 17;
  a = a * z + 1.0 / 15;
  a = a * z + 1.0 / 13;
  a = a * z + 1.0 / 11;
  a = a * z + 1.0 / 9;
  a = a * z + 1.0 / 7;
  a = a * z + 1.0 / 5;
  a = a * z + 1.0 / 3;
  return n * kLn2High + (n * kLn2Low + (2 * s + 2 * s * z * a));
}

// e^t for |t| <= 700, to about 1e-16 of it.
__attribute__((always_inline)) inline double exponential(double t) {
  const double shifted = t * 0x1.71547652b82fep0 + kShift, k = shifted - kShift;  // t / ln 2, rounded
  const double r = (t - k * kLn2High) - k * kLn2Low;
  double a = 1.0 / 6227020800;
  a = a * r + 1.0 / 479001600;
  a = a * r + 1.0 / 39916800;
  a = a * r + 1.0 / 3628800;
  a = a * r + 1.0 / 362880;
  a = a * r + 1.0 / 40320;
  a = a * r + 1.0 / 5040;
  a = a * r + 1.0 / 720;
  a = a * r + 1.0 / 120;
  a = a * r + 1.0 / 24;
  a = a * r + 1.0 / 6;
  a = a * r + 0.5;
  a = a * r + 1;
  a = a * r + 1;
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(a) + (std::bit_cast<std::int64_t>(shifted) << 52));
}

}  // namespace verisim::power
