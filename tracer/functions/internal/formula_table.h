// Shared by the files that hold the formulas of internal(n) (spec 01 section 24, 04 section 10.1).
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "tracer/math/constants.h"

namespace verisim::functions {

// One call: the point and the parameters behind it (P0, P1, ...).
struct Call3 {
  double x, y, z;
  const double* p;
};
using Formula = double (*)(const Call3&);
struct Entry {
  Formula formula;
  int extra;  // number of parameters after x, y, z
};

// Functions of SDL have numbers.
struct NumberedEntry {
  int number;
  Entry entry;
};
inline Entry entry_of(int number, std::span<const NumberedEntry> table) {
  for (const NumberedEntry& e : table)
    if (e.number == number) return e.entry;
  return {nullptr, 0};
}

inline double sq(double v) { return v * v; }
inline double cube(double v) { return v * v * v; }
inline double hyp(double a, double b) { return std::sqrt(a * a + b * b); }
// "C" of the specification: values are limited to -10 ... 10. NaN goes through as std::min and std::max leave it.
inline double limit(double v, double bound = 10) { return std::min(bound, std::max(v, -bound)); }

// The first half: polynomials; the second: everything with angles, roots, exponentials.
Entry polynomial_function(int n);  // {nullptr, 0}: not one of these
Entry transcendental_function(int n);

}  // namespace verisim::functions
