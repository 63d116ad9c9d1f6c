// Roots of a polynomial on an interval by its Bernstein (Bezier) coefficients: Descartes' rule of signs bounds their
// number, subdivision isolates them, and a bracketed Newton iteration finds each one. Finds close pairs that closed
// forms lose, needs no trigonometry, and returns roots in increasing order. Templates over the degree: shapes solve
// these for every ray.
#pragma once

#include <algorithm>
#include <cmath>

namespace verisim {

inline constexpr int kMaxBernsteinDegree = 12;

namespace bernstein {

struct Binomials {
  double c[kMaxBernsteinDegree + 1][kMaxBernsteinDegree + 1]{},
      inverse[kMaxBernsteinDegree + 1][kMaxBernsteinDegree + 1]{};
  constexpr Binomials() {
    for (int n = 0; n <= kMaxBernsteinDegree; ++n) {
      c[n][0] = inverse[n][0] = 1;
      for (int k = 1; k <= n; ++k) {
        c[n][k] = c[n - 1][k - 1] + (k < n ? c[n - 1][k] : 0);
        inverse[n][k] = 1 / c[n][k];
      }
    }
  }
};
inline constexpr Binomials kBinomials;
inline constexpr int kMaxDepth = 45;

// b_i = sum_j C(i, j) c_j, in place, by repeated sums: Bernstein coefficients, if c_j are those of powers divided by
// C(N, j).
template <int N>
void sum_binomials(double* c) {
  for (int i = 1; i <= N; ++i)
    for (int k = N; k >= i; --k) c[k] += c[k - 1];
}

// A polynomial in powers of x, constant term first, whose roots between a and b are wanted.
template <int N>
class Solver {
 public:
  Solver(const double* power, double a, double b, double* roots, int limit)
      : power_(power), roots_(roots), limit_(limit) {
    // Powers of u with x = a + (b - a) u.
    double c[N + 1];
    for (int i = 0; i <= N; ++i) c[i] = power[i];
    if (a != 0)
      for (int i = 0; i < N; ++i)
        for (int k = N - 1; k >= i; --k) c[k] += a * c[k + 1];
    double scale = 1;
    const double width = b - a;
    for (int i = 0; i <= N; ++i, scale *= width) c[i] *= scale * kBinomials.inverse[N][i];
    sum_binomials<N>(c);
    if (all_of_one_sign(c)) return;
    for (const double v : c)
      if (!std::isfinite(v)) return;
    run(c, a, b, 0);
  }
  int count() const { return count_; }

 private:
  static bool all_of_one_sign(const double* b) {
    bool positive = true, negative = true;
    for (int i = 0; i <= N; ++i) positive = positive && b[i] > 0, negative = negative && b[i] < 0;
    return positive || negative;
  }
  static int sign_changes(const double* b) {
    int changes = 0;
    double last = 0;
    for (int i = 0; i <= N; ++i) {
      changes += last * b[i] < 0;
      if (b[i] != 0) last = b[i] < 0 ? -1 : 1;
    }
    return changes;
  }
  void add(double root) {
    if (count_ < limit_ && (count_ == 0 || root > roots_[count_ - 1])) roots_[count_++] = root;
  }

  void run(const double* b, double from, double to, int depth) {
    if (count_ >= limit_) return;
    const int changes = sign_changes(b);
    if (changes == 0) {
      if (b[0] == 0) add(from);
      if (b[N] == 0) add(to);
      return;
    }
    if (changes == 1 && b[0] != 0 && b[N] != 0) return add(bracketed_root(from, to, b[0], b[N]));
    if (depth >= kMaxDepth) return add(0.5 * (from + to));
    double left[N + 1], right[N + 1];
    for (int i = 0; i <= N; ++i) right[i] = b[i];
    for (int i = 0; i <= N; ++i) {  // de Casteljau at the middle
      left[i] = right[0];
      for (int k = 0; k < N - i; ++k) right[k] = 0.5 * (right[k] + right[k + 1]);
    }
    const double middle = 0.5 * (from + to);
    run(left, from, middle, depth + 1);
    run(right, middle, to, depth + 1);
  }

  // The one root between `low` and `high`, where the values f_low and f_high have opposite signs: Newton's method, kept
  // in the bracket by bisection.
  double bracketed_root(double low, double high, double f_low, double f_high) const {
    const double end_precision = 1e-15 * std::max(std::fabs(low), std::fabs(high));
    double x = low - f_low * (high - low) / (f_high - f_low);
    if (!(x > low && x < high)) x = 0.5 * (low + high);
    double last_step = high - low;
    for (int step = 0; step < 100; ++step) {
      double f = power_[N], slope = 0;
      for (int i = N - 1; i >= 0; --i) slope = slope * x + f, f = f * x + power_[i];
      if (f == 0) return x;
      if ((f < 0) == (f_low < 0))
        low = x;
      else
        high = x;
      double next = x - f / slope;
      double move = std::fabs(next - x);
      // Bisect where Newton leaves the bracket or does not at least halve its step.
      if (!(next > low && next < high) || move > 0.5 * last_step) {
        next = 0.5 * (low + high);
        move = 0.5 * (high - low);
      }
      last_step = move;
      if (move <= end_precision) return next;
      x = next;
    }
    return x;
  }

  const double* power_;
  double* roots_;
  int limit_, count_ = 0;
};

}  // namespace bernstein

// Roots in [a, b] of power[0] + power[1] x + ... + power[N] x^N, increasing; a double root is reported once or not at
// all. At most `limit` of them.
template <int N>
int bernstein_roots(const double* power, double a, double b, double* roots, int limit = N) {
  static_assert(N >= 1 && N <= kMaxBernsteinDegree);
  return bernstein::Solver<N>(power, a, b, roots, limit).count();
}

// The same for a degree known only at run time, 1 .. kMaxBernsteinDegree.
int bernstein_roots(int degree, const double* power, double a, double b, double* roots,
                    int limit = kMaxBernsteinDegree);

}  // namespace verisim
