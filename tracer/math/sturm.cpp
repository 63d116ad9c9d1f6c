// Roots by Sturm sequences (Hook and McAree, "Using Sturm Sequences to Bracket Real Roots of Polynomial Equations",
// Graphics Gems, 1990), with POV-Ray's limits (spec 03 section 3, step 6).
#include <algorithm>
#include <cmath>

#include "tracer/math/polynomial.h"

namespace verisim {
namespace {

constexpr double kSmallCoefficient = 1e-10, kFarthestRoot = 1e7, kPrecision = 1e-12, kZeroValue = 1e-10;
constexpr int kMaxSteps = 50;

struct Chain {
  int length = 0;
  int degree[kMaxPolynomialDegree + 1];
  double c[kMaxPolynomialDegree + 1][kMaxPolynomialDegree + 1];  // leading coefficient first

  explicit Chain(int n, const double* input) {
    degree[0] = n;
    for (int i = 0; i <= n; ++i) c[0][i] = input[i] / input[0];
    degree[1] = n - 1;
    for (int i = 0; i < n; ++i) c[1][i] = c[0][i] * (n - i) / n;
    length = 2;
    while (degree[length - 1] > 0 && append_remainder()) {
    }
  }

  // Minus the remainder of the last two members, made monic up to its sign. False: it vanishes.
  bool append_remainder() {
    const int n = degree[length - 2], m = degree[length - 1];
    double work[kMaxPolynomialDegree + 1];
    std::copy_n(c[length - 2], n + 1, work);
    const double* divisor = c[length - 1];
    for (int i = 0; i + m <= n; ++i) {
      const double factor = work[i] / divisor[0];
      for (int k = 0; k <= m; ++k) work[i + k] -= factor * divisor[k];
    }
    int first = n - m + 1;
    for (int i = first; i <= n; ++i)
      if (std::fabs(work[i]) < kSmallCoefficient) work[i] = 0;
    while (first <= n && work[first] == 0) ++first;
    if (first > n) return false;
    const double size = std::fabs(work[first]);
    degree[length] = n - first;
    for (int i = first; i <= n; ++i) c[length][i - first] = -work[i] / size;
    ++length;
    return true;
  }

  double value(double x) const { return evaluate_polynomial(degree[0], c[0], x); }

  int sign_changes(double x) const {
    int changes = 0;
    double last = 0;
    for (int i = 0; i < length; ++i) {
      const double v = evaluate_polynomial(degree[i], c[i], x);
      if (v == 0) continue;
      if (last != 0 && (v < 0) != (last < 0)) ++changes;
      last = v;
    }
    return changes;
  }
};

// A root between a and b, where the values have opposite signs; false if the steps do not suffice.
bool regula_falsi(const Chain& chain, double a, double b, double& root) {
  double fa = chain.value(a), fb = chain.value(b);
  if (fa * fb > 0) return false;
  if (std::fabs(fa) < kZeroValue) {
    root = a;
    return true;
  }
  if (std::fabs(fb) < kZeroValue) {
    root = b;
    return true;
  }
  double last = fa;
  for (int step = 0; step < kMaxSteps; ++step) {
    const double x = (fb * a - fa * b) / (fb - fa), fx = chain.value(x);
    if (std::fabs(x) > kPrecision ? std::fabs(fx / x) < kPrecision : std::fabs(fx) < kPrecision) {
      root = x;
      return true;
    }
    if ((fx < 0) != (fa < 0)) {
      b = x, fb = fx;
      if (last * fx > 0) fa /= 2;
    } else {
      a = x, fa = fx;
      if (last * fx > 0) fb /= 2;
    }
    if (std::fabs(b - a) < kPrecision) {
      root = x;
      return true;
    }
    last = fx;
  }
  return false;
}

// No more than `room` roots: of polynomials along rays from far away the counts are noise, and promise many more than
// the degree.
int isolate(const Chain& chain, double low, double high, int changes_low, int changes_high, int room, double* roots) {
  const int count = changes_low - changes_high;
  if (count <= 0 || room <= 0) return 0;
  if (count == 1 && regula_falsi(chain, low, high, roots[0])) return 1;
  double middle = low;
  for (int step = 0; step < kMaxSteps; ++step) {
    middle = 0.5 * (low + high);
    const int changes = chain.sign_changes(middle);
    const double width = std::fabs(middle) > kPrecision ? std::fabs((high - low) / middle) : std::fabs(high - low);
    if (width < kPrecision) break;
    const int left = changes_low - changes, right = changes - changes_high;
    if (left > 0 && right > 0) {
      const int found = isolate(chain, low, middle, changes_low, changes, room, roots);
      return found + isolate(chain, middle, high, changes, changes_high, room - found, roots + found);
    }
    if (left > 0)
      high = middle, changes_high = changes;
    else
      low = middle, changes_low = changes;
  }
  roots[0] = middle;  // a multiple root, or one that regula falsi did not come to
  return 1;
}

}  // namespace

int solve_sturm(int degree, const double* c, double* roots) {
  for (int i = 0; i <= degree; ++i)
    if (!std::isfinite(c[i])) return 0;
  while (degree > 0 && c[0] == 0) ++c, --degree;
  if (degree == 0) return 0;
  if (degree == 1) {
    roots[0] = -c[1] / c[0];
    return roots[0] >= 0 ? 1 : 0;
  }
  const Chain chain(degree, c);
  const int at_zero = chain.sign_changes(0);
  if (at_zero == 0) return 0;
  return isolate(chain, 0, kFarthestRoot, at_zero, chain.sign_changes(kFarthestRoot), degree, roots);
}

}  // namespace verisim
