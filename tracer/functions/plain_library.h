// The C library's functions of one number, as formulas call them that are written once for one number and for lanes
// (library_lanes-inl.h).
#pragma once

#include <cmath>

namespace verisim::functions {

enum class LibraryFunction { sin, cos, atan, atan2, log, exp, sinh, cosh };

template <LibraryFunction F>
double plain_library(double a, [[maybe_unused]] double b) {
  using enum LibraryFunction;
  if constexpr (F == sin) return std::sin(a);
  if constexpr (F == cos) return std::cos(a);
  if constexpr (F == atan) return std::atan(a);
  if constexpr (F == atan2) return std::atan2(a, b);
  if constexpr (F == log) return std::log(a);
  if constexpr (F == exp) return std::exp(a);
  if constexpr (F == sinh) return std::sinh(a);
  if constexpr (F == cosh) return std::cosh(a);
}

template <class Value>
struct SineAndCosine {
  Value sine, cosine;
};

struct PlainLibrary {
  using Value = double;

  PlainLibrary among(bool) const { return *this; }

  SineAndCosine<double> sine_and_cosine(double a) const { return {std::sin(a), std::cos(a)}; }
  double atan(double a) const { return std::atan(a); }
  double atan2(double y, double x) const { return std::atan2(y, x); }
  double log(double a) const { return std::log(a); }
  double exp(double a) const { return std::exp(a); }
  double sinh(double a) const { return std::sinh(a); }
  double cosh(double a) const { return std::cosh(a); }
};

}  // namespace verisim::functions
