// Closed intervals, rounded outwards: whatever the numbers in the operands, the result is inside.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace verisim::functions {

struct Interval {
  double low = 0, high = 0;

  double magnitude() const { return std::max(std::fabs(low), std::fabs(high)); }
  // Of the number nearest to zero.
  double least_magnitude() const { return low > 0 ? low : high < 0 ? -high : 0; }
  bool finite() const { return magnitude() <= std::numeric_limits<double>::max(); }

  static Interval everything() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  // By more than the rounding of a basic operation, or of a function of the C library.
  static Interval around(double low, double high) {
    constexpr double kRelative = 0x1p-51, kLeast = 0x1p-1000;
    return {low - (std::fabs(low) * kRelative + kLeast), high + (std::fabs(high) * kRelative + kLeast)};
  }
};

inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
inline Interval operator+(const Interval& a, const Interval& b) {
  return Interval::around(a.low + b.low, a.high + b.high);
}
inline Interval operator-(const Interval& a, const Interval& b) { return a + -b; }
inline Interval operator*(const Interval& a, const Interval& b) {
  if ((a.low == 0 && a.high == 0) || (b.low == 0 && b.high == 0)) return {};  // derivatives that are zero stay so
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  if (!(std::fabs(p) + std::fabs(q) + std::fabs(r) + std::fabs(s) <= std::numeric_limits<double>::max()))
    return Interval::everything();
  return Interval::around(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}
inline Interval operator*(double a, const Interval& b) { return Interval{a, a} * b; }
inline Interval square(const Interval& a) {
  const double least = a.least_magnitude(), most = a.magnitude();
  return Interval::around(least * least, most * most);
}
// A sine of the numbers in a.
Interval sine(const Interval& a);
inline Interval cosine(const Interval& a) {
  constexpr double kQuarter = 1.57079632679489661923;
  return sine(a + Interval::around(kQuarter, kQuarter));
}

}  // namespace verisim::functions
