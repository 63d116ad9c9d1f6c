#include "tracer/shapes/quadrics/quadric_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace verisim::shapes {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The least a x^2 + b x over low <= x <= high.
double least(double a, double b, double low, double high) {
  const auto value = [&](double x) {
    if (std::isfinite(x)) return x * (a * x + b);
    if (a != 0) return a > 0 ? kInfinity : -kInfinity;
    if (b != 0) return (b > 0) == (x > 0) ? kInfinity : -kInfinity;
    return 0.0;
  };
  double m = std::min(value(low), value(high));
  if (const double x = -b / (2 * a); a > 0 && x > low && x < high) m = std::min(m, value(x));
  return m;
}

// Narrows low .. high to where a x^2 + b x <= most can hold.
void solve(double a, double b, double most, double& low, double& high) {
  if (!std::isfinite(most)) return;
  double from = -kInfinity, to = kInfinity;
  if (a > 0) {
    const double middle = -b / (2 * a), half2 = most / a + middle * middle;
    const double doubt =
        1e-12 * (std::fabs(most / a) + middle * middle);  // the root of a small difference is not small
    const double half = std::sqrt(std::max(half2, 0.0) + doubt);
    from = middle - half, to = middle + half;
  } else if (a == 0 && b != 0) {
    (b > 0 ? to : from) = most / b;
  }
  if (!(std::isfinite(from) || std::isfinite(to))) return;
  low = std::max(low, from - 1e-9 * (1 + std::fabs(from)));
  high = std::min(high, to + 1e-9 * (1 + std::fabs(to)));
}

}  // namespace

Box3 narrowed(const Box3& known, const scene::Quadric& q) {
  if (q.mixed != Vec3(0)) return known;
  Box3 box = known;
  // Each axis by what the others leave it, until nothing more can be learnt of infinite sides.
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const double others = least(q.square[j], q.linear[j], box.min[j], box.max[j]) +
                            least(q.square[k], q.linear[k], box.min[k], box.max[k]);
      solve(q.square[i], q.linear[i], -q.constant - others, box.min[i], box.max[i]);
    }
  }
  return box;
}

}  // namespace verisim::shapes
