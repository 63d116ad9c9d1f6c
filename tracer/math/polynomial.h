// Real roots of polynomials, with the thresholds and the habits of POV-Ray's solver (spec 03 section 3): pictures
// depend on which roots it finds.
#pragma once

#include <cmath>

namespace verisim {

inline constexpr int kMaxPolynomialDegree = 35;

// Roots of c[0] x^degree + ... + c[degree]; returns their number (at most `degree`), unsorted. Degrees up to 4 are
// solved in closed form unless `sturm`; higher degrees, and all with `sturm`, by Sturm sequences, which only find roots
// in [0, 1e7] and report multiple roots once. `elimination`: if positive, a root whose relative size is below it (a
// ray's own starting point) is divided out of cubics and quartics first. Roots that are not between `from` and `to`
// need not be right, only beyond.
int solve_polynomial(int degree, const double* c, double* roots, bool sturm = false, double elimination = 0,
                     double from = 0, double to = HUGE_VAL);

// c[0] x^2 + c[1] x + c[2], the larger root first; nearly equal roots are reported once (step 3).
int solve_quadratic(const double* c, double* roots);
// Closed form of degree 3 (step 4).
int solve_cubic(const double* c, double* roots);
// Sturm sequences alone (step 6).
int solve_sturm(int degree, const double* c, double* roots, double from = 0, double to = HUGE_VAL);

inline double evaluate_polynomial(int degree, const double* c, double x) {
  double value = c[0];
  for (int i = 1; i <= degree; ++i) value = value * x + c[i];
  return value;
}

}  // namespace verisim
