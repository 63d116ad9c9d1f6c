#include "tracer/shapes/swept/plane_curve.h"

#include <algorithm>
#include <cmath>

#include "tracer/math/polynomial.h"

namespace verisim::shapes {

CurveSegment CurveSegment::linear(const Vec2& p0, const Vec2& p1) { return {{p0, p1 - p0, Vec2(0), Vec2(0)}, 1}; }

CurveSegment CurveSegment::quadratic(const Vec2& p0, const Vec2& p1, const Vec2& p2) {
  return {{p1, 0.5 * (p2 - p0), 0.5 * p0 - p1 + 0.5 * p2, Vec2(0)}, 2};
}

CurveSegment CurveSegment::cubic(const Vec2& p0, const Vec2& p1, const Vec2& p2, const Vec2& p3) {
  return {{p1, 0.5 * (p2 - p0), p0 - 2.5 * p1 + 2.0 * p2 - 0.5 * p3, -0.5 * p0 + 1.5 * p1 - 1.5 * p2 + 0.5 * p3}, 3};
}

CurveSegment CurveSegment::bezier(const Vec2& p0, const Vec2& p1, const Vec2& p2, const Vec2& p3) {
  return {{p0, 3.0 * p1 - 3.0 * p0, 3.0 * p2 - 6.0 * p1 + 3.0 * p0, p3 - 3.0 * p2 + 3.0 * p1 - p0}, 3};
}

int CurveSegment::count_beyond(int axis, double v, double least, bool sturm) const {
  double falling[4], roots[3];
  for (int i = 0; i <= degree; ++i) falling[degree - i] = c[static_cast<std::size_t>(i)][axis];
  falling[degree] -= v;
  int count = 0;
  const int n = solve_polynomial(degree, falling, roots, sturm);
  for (int i = 0; i < n; ++i) count += roots[i] >= 0 && roots[i] <= 1 && value(1 - axis, roots[i]) >= least;
  return count;
}

void CurveSegment::extremes(int axis, double& low, double& high) const {
  low = std::min(value(axis, 0), value(axis, 1)), high = std::max(value(axis, 0), value(axis, 1));
  double roots[2];
  int n = 0;
  const double a = 3 * c[3][axis], b = 2 * c[2][axis], k = c[1][axis];
  if (a != 0) {
    const double discriminant = b * b - 4 * a * k;
    if (discriminant >= 0) {
      const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
      roots[n++] = q / a;
      if (q != 0) roots[n++] = k / q;
    }
  } else if (b != 0) {
    roots[n++] = -k / b;
  }
  for (int i = 0; i < n; ++i) {
    if (!(roots[i] > 0 && roots[i] < 1)) continue;
    const double v = value(axis, roots[i]);
    low = std::min(low, v), high = std::max(high, v);
  }
}

Rectangle CurveSegment::bounds(double from, double to) const {
  // The four Bezier points of this interval.
  const double h = to - from;
  const Vec2 q0 = ((c[3] * from + c[2]) * from + c[1]) * from + c[0];
  const Vec2 q1 = h * ((3.0 * c[3] * from + 2.0 * c[2]) * from + c[1]), q2 = h * h * (3.0 * c[3] * from + c[2]),
             q3 = h * h * h * c[3];
  Rectangle r(q0);
  r.extendBy(q0 + q1 / 3.0);
  r.extendBy(q0 + (2.0 * q1 + q2) / 3.0);
  r.extendBy(q0 + q1 + q2 + q3);
  double size = 0;
  for (const Vec2& v : c) size = std::max({size, std::fabs(v.x), std::fabs(v.y)});
  return Rectangle(r.min - Vec2(1e-12 * size), r.max + Vec2(1e-12 * size));
}

}  // namespace verisim::shapes
