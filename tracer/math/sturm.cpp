// Roots by Sturm sequences (Hook and McAree, "Using Sturm Sequences to Bracket Real Roots of Polynomial Equations",
// Graphics Gems, 1990), with POV-Ray's limits (spec 03 section 3, step 6).
#include <algorithm>
#include <cmath>

#include "tracer/math/polynomial.h"

namespace verisim {
namespace {

constexpr double kSmallCoefficient = 1e-10, kFarthestRoot = 1e7, kPrecision = 1e-12, kZeroValue = 1e-10;
constexpr int kMaxSteps = 50;

double quartic(const double* c, double x) { return (((c[0] * x + c[1]) * x + c[2]) * x + c[3]) * x + c[4]; }

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

  // Minus the remainder of the last two members, made monic up to its sign. A remainder without x ends the chain, be it
  // 0. False: it is the last one.
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
    while (first < n && std::fabs(work[first]) < kSmallCoefficient) ++first;
    if (first == n && std::fabs(work[n]) < kSmallCoefficient) work[n] = 0;
    // Each step of the division by a member with a negative leading coefficient turns the sign.
    const bool turned = divisor[0] < 0 && (n - m) % 2 == 0;
    const double size = work[first] == 0 ? 1 : std::fabs(work[first]), divided_by = turned ? size : -size;
    degree[length] = n - first;
    for (int i = first; i <= n; ++i) c[length][i - first] = work[i] / divided_by;
    ++length;
    return first < n;
  }

  double value(double x) const { return degree[0] == 4 ? quartic(c[0], x) : evaluate_polynomial(degree[0], c[0], x); }

  int sign_changes(double x) const {
    if (length == 5 && degree[0] == 4) {
      const double v[5] = {quartic(c[0], x), evaluate_polynomial(3, c[1], x), evaluate_polynomial(2, c[2], x),
                           evaluate_polynomial(1, c[3], x), c[4][0]};
      if ((v[0] != 0) & (v[1] != 0) & (v[2] != 0) & (v[3] != 0))
        return ((v[0] < 0) ^ (v[1] < 0)) + ((v[1] < 0) ^ (v[2] < 0)) + ((v[2] < 0) ^ (v[3] < 0)) +
               ((v[3] < 0) ^ (v[4] < 0));
    }
    // What follows a zero counts as a change, so at a multiple root rounding decides.
    int changes = 0;
    double last = value(x);
    for (int i = 1; i < length; ++i) {
      const double v = evaluate_polynomial(degree[i], c[i], x);
      changes += last == 0 || last * v < 0;
      last = v;
    }
    return changes;
  }

  // All partial sums of Horner's rule have the sign of the leading coefficient, for each member: beyond this place no
  // sign changes, for sums grow with the place, and rounding keeps their order.
  bool beyond_all_roots(double x) const {
    for (int i = 0; i < length; ++i) {
      const double sign = c[i][0] < 0 ? -1 : 1;
      double v = sign * c[i][0];
      for (int k = 1; k <= degree[i]; ++k)
        if (!((v = v * x + sign * c[i][k]) > 0)) return false;
    }
    return true;
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

// From 0 to the farthest root regula falsi of a quartic, or more, mostly creeps: it halves the value at the far end in
// all of its steps, and that still is so huge that it never leaves a neighbourhood of 0 in which the value hardly
// changes. `far`: the value at the farthest root.
bool creeps(const Chain& chain, double far) {
  const int n = chain.degree[0];
  const double near = chain.c[0][n], size = std::fabs(near);
  const double reached = 4 * (1.5 * size * kFarthestRoot / std::fabs(far)) * (1ull << (kMaxSteps + 1));
  if (!(size > 10 * kZeroValue && near * far < 0 && reached < 1)) return false;
  double change = 0;
  for (int i = 0; i < n; ++i) change = (change + std::fabs(chain.c[0][i])) * reached;
  return change < 0.5 * size;
}

// The roots of a polynomial, from the least to the greatest.
class Isolation {
 public:
  // Of what is not between `from` and `to` it only counts that it is beyond.
  Isolation(const Chain& chain, double from, double to, double* roots)
      : chain_(chain), from_(from * (1 - kMargin)), to_(to * (1 + kMargin)), roots_(roots) {
    const int changes_near = chain.sign_changes(0), changes_far = chain.sign_changes(kFarthestRoot);
    const bool single = changes_near - changes_far == 1;
    if (single && !creeps(chain, chain.value(kFarthestRoot)) && found_by_regula_falsi(0, kFarthestRoot)) return;
    // Halving towards 0 until the first place before a root of any member.
    int steps = 0;
    double high = kFarthestRoot;
    for (int skip = 32; skip > 0; skip /= 2) {
      const double place = std::ldexp(high, -skip);
      if (steps + skip < kMaxSteps && chain.beyond_all_roots(place)) steps += skip, high = place;
    }
    if (changes_near > changes_far) bisect(0, high, changes_near, changes_far, steps);
  }
  int count() const { return count_; }

 private:
  static constexpr double kMargin = 1e-9;

  // No more roots than the degree: of polynomials along rays from far away the counts are noise, and promise many more.
  void find(double low, double high, int changes_low, int changes_high) {
    const int count = changes_low - changes_high;
    if (count <= 0 || count_ >= chain_.degree[0]) return;
    if (low > to_) return add(high);
    if (count == 1 && high < from_) return add(low);
    if (count == 1 && found_by_regula_falsi(low, high)) return;
    bisect(low, high, changes_low, changes_high, 0);
  }

  bool found_by_regula_falsi(double low, double high) {
    double root;
    if (!regula_falsi(chain_, low, high, root)) return false;
    add(root);
    return true;
  }

  void bisect(double low, double high, int changes_low, int changes_high, int steps) {
    const bool single = changes_low - changes_high == 1;
    double middle = high;
    for (; steps < kMaxSteps; ++steps) {
      middle = 0.5 * (low + high);
      const int changes = chain_.sign_changes(middle);
      // Rounding, beside a multiple root: POV-Ray gives that up.
      if (single && changes != changes_low && changes != changes_high) return;
      const double width = std::fabs(middle) > kPrecision ? std::fabs((high - low) / middle) : std::fabs(high - low);
      if (width < kPrecision) break;
      if (!single && changes != changes_low && changes != changes_high) {
        find(low, middle, changes_low, changes);
        return find(middle, high, changes, changes_high);
      }
      (changes == changes_low ? low : high) = middle;
    }
    add(middle);  // a multiple root, or one that regula falsi did not come to
  }

  void add(double root) { roots_[count_++] = root; }

  const Chain& chain_;
  const double from_, to_;
  double* roots_;
  int count_ = 0;
};

}  // namespace

int solve_sturm(int degree, const double* c, double* roots, double from, double to) {
  for (int i = 0; i <= degree; ++i)
    if (!std::isfinite(c[i])) return 0;
  while (degree > 0 && c[0] == 0) ++c, --degree;
  if (degree == 0) return 0;
  if (degree == 1) {
    roots[0] = -c[1] / c[0];
    return roots[0] >= 0 ? 1 : 0;
  }
  return Isolation(Chain(degree, c), from, to, roots).count();
}

}  // namespace verisim
