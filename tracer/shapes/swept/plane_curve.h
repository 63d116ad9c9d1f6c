// Polynomial curve segments in the plane: the profiles of lathes and the outlines of prisms (spec 03 4.15, 4.17).
#pragma once

#include <array>
#include <vector>

#include "tracer/scene/object.h"
#include "tracer/shapes/swept/outline_index.h"

namespace verisim::shapes {

// point(w) = ((c[3] w + c[2]) w + c[1]) w + c[0] for 0 <= w <= 1.
struct CurveSegment {
  std::array<Vec2, 4> c{Vec2(0), Vec2(0), Vec2(0), Vec2(0)};
  int degree = 1;

  double value(int axis, double w) const { return ((c[3][axis] * w + c[2][axis]) * w + c[1][axis]) * w + c[0][axis]; }
  double slope(int axis, double w) const { return (3 * c[3][axis] * w + 2 * c[2][axis]) * w + c[1][axis]; }
  // How often a coordinate takes a value where the other one is at `least` or beyond. By POV-Ray's closed forms, or
  // Sturm sequences, whose roots at the ends of a segment are not quite 0 and 1 (spec 08 F).
  int count_beyond(int axis, double value, double least, bool sturm) const;
  // Smallest and largest coordinate on the segment.
  void extremes(int axis, double& low, double& high) const;
  // A rectangle around the points of from <= w <= to, wider than they are rounded.
  Rectangle bounds(double from, double to) const;

  static CurveSegment linear(const Vec2& p0, const Vec2& p1);
  static CurveSegment quadratic(const Vec2& p0, const Vec2& p1, const Vec2& p2);  // from p1 to p2
  static CurveSegment cubic(const Vec2& p0, const Vec2& p1, const Vec2& p2,
                            const Vec2& p3);  // Catmull-Rom, from p1 to p2
  static CurveSegment bezier(const Vec2& p0, const Vec2& p1, const Vec2& p2, const Vec2& p3);  // from p0 to p3
};

}  // namespace verisim::shapes
