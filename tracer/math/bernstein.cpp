#include "tracer/math/bernstein.h"

#include <algorithm>
#include <cmath>

namespace verisim {
namespace {

constexpr int kMaxDepth = 45;

struct Binomials {
  double c[kMaxBernsteinDegree + 1][kMaxBernsteinDegree + 1]{};
  constexpr Binomials() {
    for (int n = 0; n <= kMaxBernsteinDegree; ++n) {
      c[n][0] = 1;
      for (int k = 1; k <= n; ++k) c[n][k] = c[n - 1][k - 1] + (k < n ? c[n - 1][k] : 0);
    }
  }
};
constexpr Binomials kBinomials;

int sign_changes(int degree, const double* b) {
  int changes = 0;
  double last = 0;
  for (int i = 0; i <= degree; ++i) {
    if (b[i] == 0) continue;
    if (last != 0 && (b[i] < 0) != (last < 0)) ++changes;
    last = b[i];
  }
  return changes;
}

// The one root in [0, 1]; the ends have opposite signs. T. R. Chandrupatla, "A new hybrid quadratic/bisection algorithm for finding the zero of a
// nonlinear function without using derivatives", Advances in Engineering Software 28 (1997).
double bracketed_root(int degree, const double* coefficients) {
  constexpr double kTolerance = 1e-15;
  double a = 1, fa = coefficients[degree], b = 0, fb = coefficients[0], c = b, fc = fb;
  double t = 0.5;
  for (int step = 0; step < 80; ++step) {
    const double x = a + t * (b - a), f = evaluate_bernstein(degree, coefficients, x);
    if ((f < 0) == (fa < 0)) {
      c = a, fc = fa;
    } else {
      c = b, fc = fb;
      b = a, fb = fa;
    }
    a = x, fa = f;
    const bool a_is_better = std::fabs(fa) < std::fabs(fb);
    const double best = a_is_better ? a : b, limit = kTolerance / std::fabs(b - c);
    if (limit > 0.5 || (a_is_better ? fa : fb) == 0) return best;
    const double xi = (a - b) / (c - b), phi = (fa - fb) / (fc - fb);
    t = 0.5;
    if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
      t = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
    t = std::clamp(t, limit, 1 - limit);
  }
  return a;
}

struct Search {
  int degree, limit, count = 0;
  double* roots;

  void add(double root) {
    if (count < limit && (count == 0 || root > roots[count - 1])) roots[count++] = root;
  }

  void run(const double* b, double from, double to, int depth) {
    if (count >= limit) return;
    const int changes = sign_changes(degree, b);
    if (changes == 0) {
      if (b[0] == 0) add(from);
      if (b[degree] == 0) add(to);
      return;
    }
    if (changes == 1 && b[0] != 0 && b[degree] != 0) return add(from + (to - from) * bracketed_root(degree, b));
    if (depth >= kMaxDepth) return add(0.5 * (from + to));
    double left[kMaxBernsteinDegree + 1], right[kMaxBernsteinDegree + 1];
    std::copy_n(b, degree + 1, right);
    for (int i = 0; i <= degree; ++i) {  // de Casteljau at the middle
      left[i] = right[0];
      for (int k = 0; k < degree - i; ++k) right[k] = 0.5 * (right[k] + right[k + 1]);
    }
    // `right` now holds the right half in reverse order of completion: its entry k is the k-th of that half.
    const double middle = 0.5 * (from + to);
    run(left, from, middle, depth + 1);
    run(right, middle, to, depth + 1);
  }
};

}  // namespace

void bernstein_from_power(int degree, const double* power, double a, double b, double* bernstein) {
  // p(a + (b - a) u) in powers of u, by synthetic division and scaling.
  double c[kMaxBernsteinDegree + 1];
  std::copy_n(power, degree + 1, c);
  for (int i = 0; i < degree; ++i)
    for (int k = degree - 1; k >= i; --k) c[k] += a * c[k + 1];
  double scale = 1;
  for (int i = 0; i <= degree; ++i, scale *= b - a) c[i] *= scale / kBinomials.c[degree][i];
  // b_i = sum_j C(i, j) c_j, a running sum of differences.
  for (int i = 0; i <= degree; ++i) {
    double sum = 0;
    for (int j = 0; j <= i; ++j) sum += kBinomials.c[i][j] * c[j];
    bernstein[i] = sum;
  }
}

double evaluate_bernstein(int degree, const double* b, double u) {
  const double v = 1 - u;
  double value = b[0], power = 1;
  for (int i = 1; i <= degree; ++i) {
    power *= u;
    value = value * v + kBinomials.c[degree][i] * power * b[i];
  }
  return value;
}

int bernstein_roots(int degree, const double* bernstein, double* roots, int limit) {
  for (int i = 0; i <= degree; ++i)
    if (!std::isfinite(bernstein[i])) return 0;
  Search search{degree, limit, 0, roots};
  search.run(bernstein, 0, 1, 0);
  return search.count;
}

}  // namespace verisim
