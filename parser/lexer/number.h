// Literal numbers, correctly rounded.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "parser/lexer/characters.h"

namespace verisim::parser {

inline constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                          1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// Decimal digits with one optional point and an optional exponent, which may be empty (spec 01 1.2).
inline bool starts_number(const char* p) { return is_digit(*p) || (*p == '.' && is_digit(p[1])); }

inline double convert_number(const char* first, const char* last, int power) {
  double value = 0;
  const auto result = std::from_chars(first, last, value);
  if (result.ec != std::errc::result_out_of_range) return value;
  // Out of range: inf or 0, by the decimal exponent of the first non-zero digit.
  std::ptrdiff_t magnitude = 0;
  const char* p = first;
  while (p != last && *p == '0') ++p;
  if (p != last && is_digit(*p)) {
    while (p != last && is_digit(*p)) ++p, ++magnitude;
  } else if (p != last && *p == '.') {
    ++p;
    while (p != last && *p == '0') ++p, --magnitude;
  }
  return magnitude + power > 0 ? std::numeric_limits<double>::infinity() : 0.0;
}

// False: a second point.
inline bool read_number(const char*& p, double& value) {
  const char* const first = p;
  std::uint64_t mantissa = 0;
  while (is_digit(*p)) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p++ - '0');
  std::ptrdiff_t digits = p - first;
  bool point = false, exponent = false;
  int scale = 0;
  if (*p == '.') {
    point = true;
    const char* fraction = ++p;
    while (is_digit(*p)) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p++ - '0');
    digits += p - fraction;
    scale = static_cast<int>(std::min<std::ptrdiff_t>(p - fraction, 10000));
  }
  const char* number_end = p;
  int power = 0;
  if (*p == 'e' || *p == 'E') {
    exponent = true;
    ++p;
    bool negative = false;
    if (*p == '+' || *p == '-') negative = *p++ == '-';
    const char* exponent_digits = p;
    while (is_digit(*p)) {
      if (power < 100000) power = power * 10 + (*p - '0');
      ++p;
    }
    if (p != exponent_digits) number_end = p;
    if (negative) power = -power;
  }
  if (*p == '.' && (point || exponent)) return false;
  const int shift = power - scale;
  if (digits <= 18 && mantissa < (std::uint64_t{1} << 53) && shift >= -22 && shift <= 22) {
    // Both factors are exact doubles, so one rounding gives the correctly rounded result.
    value = static_cast<double>(mantissa);
    value = shift < 0 ? value / kPowersOfTen[-shift] : value * kPowersOfTen[shift];
  } else {
    value = convert_number(first, number_end, power);
  }
  return true;
}

}  // namespace verisim::parser
