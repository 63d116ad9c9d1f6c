#include "tracer/math/polynomial.h"

#include <algorithm>
#include <cmath>

#include "tracer/math/vec.h"

namespace verisim {
namespace {

constexpr double kForceSturm =
    1e12;  // ratio of coefficients beyond which POV-Ray does not trust the closed form of degree 4

bool closed_form_is_difficult(const double* c) {
  // POV-Ray compares with the signed reference, so a negative one is replaced by any successor.
  double reference = c[0];
  for (int i = 1; i <= 4; ++i)
    if (std::fabs(c[i]) > reference) reference = c[i];
  for (int i = 0; i <= 4; ++i)
    if (c[i] != 0 && std::fabs(reference / c[i]) > kForceSturm) return true;
  return false;
}

// What the closed forms of a cubic's roots are made of: Vieta's where it has three, Cardano's where it has one.
struct DepressedCubic {
  double q, r, q3, d, third;
  explicit DepressedCubic(const double* c) {
    const double a1 = c[1] / c[0], a2 = c[2] / c[0], a3 = c[3] / c[0];
    const double square = a1 * a1;
    q = (square - 3.0 * a2) / 9.0;
    r = (a1 * (square - 4.5 * a2) + 13.5 * a3) / 27.0;
    q3 = q * q * q, d = q3 - r * r, third = a1 / 3.0;
  }
  bool three_roots() const { return d >= 0; }
  // q3 = 0 makes 0/0 here: an exact triple root is lost, as in POV-Ray.
  double theta() const { return std::acos(std::clamp(r / std::sqrt(q3), -1.0, 1.0)) / 3.0; }
  double of_three(double angle) const { return -2.0 * std::sqrt(q) * std::cos(angle) - third; }
  double only_root() const {
    // Not std::cbrt, whose last bit often is another one than POV-Ray's.
    const double s = std::pow(std::sqrt(-d) + std::fabs(r), 1.0 / 3.0);
    return (r < 0 ? s + q / s : -(s + q / s)) - third;
  }
  // The one that solve_cubic reports first.
  double first_root() const { return three_roots() ? of_three(theta()) : only_root(); }
};

int solve_quartic_closed(const double* c, double* roots) {
  const double c1 = c[1] / c[0], c2 = c[2] / c[0], c3 = c[3] / c[0], c4 = c[4] / c[0];
  const double c12 = c1 * c1;
  const double p = c2 - 0.375 * c12;
  const double q = 0.125 * c12 * c1 - 0.5 * c1 * c2 + c3;
  const double r = -3.0 / 256.0 * c12 * c12 + 0.0625 * c12 * c2 - 0.25 * c1 * c3 + c4;

  const double resolvent[4] = {1.0, -0.5 * p, -r, 0.5 * r * p - 0.125 * q * q};
  const double z = DepressedCubic(resolvent).first_root();

  double u = 2.0 * z - p, v;
  if (u < 0) {
    if (u <= -kEpsilon) return 0;
    u = 0;
  }
  if (u < kEpsilon) {
    v = z * z - r;
    if (v < 0) return 0;
    v = std::sqrt(v);
  } else {
    u = std::sqrt(u);
    v = 0.5 * q / u;
  }
  // (x^2 + z)^2 = (u x - v)^2, so x^2 -+ u x + z +- v = 0.
  int n = 0;
  const double shift = -0.25 * c1;
  const auto add_pair = [&](double middle, double constant) {
    const double discriminant = middle * middle - constant;
    if (discriminant > 0) {
      const double root = std::sqrt(discriminant);
      roots[n++] = middle + root + shift;
      roots[n++] = middle - root + shift;
    } else if (discriminant == 0) {
      roots[n++] = middle - shift;  // the other sign, as in POV-Ray, which so loses most double roots
    }
  };
  add_pair(0.5 * u, z + v);
  add_pair(-0.5 * u, z - v);
  return n;
}

}  // namespace

int solve_quadratic(const double* c, double* roots) {
  double a = c[0], b = c[1];
  if (std::fabs(a) < kEpsilon) {
    if (std::fabs(b) < kEpsilon) return 0;
    roots[0] = -c[2] / b;
    return 1;
  }
  b /= a;
  const double k = c[2] / a;
  const double discriminant = b * b - 4.0 * k;
  if (std::fabs(discriminant) < kEpsilon) {
    roots[0] = -0.5 * b;
    return 1;
  }
  if (!(discriminant > 0)) return 0;
  const double root = std::sqrt(discriminant);
  roots[0] = 0.5 * (-b + root);
  roots[1] = 0.5 * (-b - root);
  return 2;
}

int solve_cubic(const double* c, double* roots) {
  const DepressedCubic cubic(c);
  if (!cubic.three_roots()) {
    roots[0] = cubic.only_root();
    return 1;
  }
  // A third of a turn, and two, each rounded by itself: POV-Ray's roots to the last bit.
  constexpr double kThird = 2.0943951023931954923, kTwoThirds = 4.1887902047863909846;
  const double theta = cubic.theta();
  roots[0] = cubic.of_three(theta);
  roots[1] = cubic.of_three(theta + kThird);
  roots[2] = cubic.of_three(theta + kTwoThirds);
  return 3;
}

int solve_polynomial(int degree, const double* c, double* roots, bool sturm, double elimination, double from,
                     double to) {
  while (degree > 0 && std::fabs(c[0]) < kEpsilon) ++c, --degree;
  const auto near_zero_root = [&](int n) {
    return elimination > 0 && c[n - 1] != 0 && std::fabs(c[n] / c[n - 1]) < elimination;
  };
  const auto cubic = [&] { return sturm ? solve_sturm(3, c, roots, from, to) : solve_cubic(c, roots); };
  switch (degree) {
    case 0:
      return 0;
    case 1:
      roots[0] = -c[1] / c[0];
      return 1;
    case 2:
      return solve_quadratic(c, roots);
    case 3:
      return near_zero_root(3) ? solve_quadratic(c, roots) : cubic();
    case 4:
      if (near_zero_root(4)) return cubic();
      return sturm || closed_form_is_difficult(c) ? solve_sturm(4, c, roots, from, to) : solve_quartic_closed(c, roots);
    default:
      return solve_sturm(degree, c, roots, from, to);
  }
}

}  // namespace verisim
