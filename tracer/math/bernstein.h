// Roots of a polynomial on an interval by its Bernstein (Bezier) coefficients: Descartes' rule of signs bounds their number, subdivision isolates them,
// and a bracketed secant finds each one. Finds close pairs that closed forms lose, needs no trigonometry, and returns roots in increasing order.
#pragma once

namespace verisim {

inline constexpr int kMaxBernsteinDegree = 12;

// Bernstein coefficients on [a, b] of power[0] + power[1] x + ... + power[degree] x^degree.
void bernstein_from_power(int degree, const double* power, double a, double b, double* bernstein);
// Value at u in [0, 1].
double evaluate_bernstein(int degree, const double* bernstein, double u);
// Roots in [0, 1], increasing; a double root that is missed or merged by rounding is reported at most once. Returns at most `limit` of them.
int bernstein_roots(int degree, const double* bernstein, double* roots, int limit = kMaxBernsteinDegree);

}  // namespace verisim
