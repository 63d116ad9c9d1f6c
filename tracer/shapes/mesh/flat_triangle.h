// A triangle as rays are tested against it: its plane, and its corners in the two axes beside the dominant one of its
// normal (spec 04 1.2).
#pragma once

#include <cmath>
#include <type_traits>

#include "tracer/math/vec.h"

namespace verisim::shapes {

// The axis of the largest component, with POV-Ray's tie rule.
inline int dominant_axis(const Vec3& v) {
  const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
  if (x > y) return x > z ? 0 : 2;
  return y > z ? 1 : 2;
}

struct PlaneAxes {
  int u, v;
};
constexpr PlaneAxes axes_beside(int dominant) { return {dominant == 0 ? 1 : 0, dominant == 2 ? 1 : 2}; }

// POV-Ray exchanges the first two corners of such a triangle, so that all turn the same way in their projection.
inline bool turns_clockwise(const Vec3& p1, const Vec3& p2, const Vec3& p3, PlaneAxes axes) {
  const auto [i, j] = axes;
  return (p2[i] - p3[i]) * (p2[j] - p1[j]) < (p2[j] - p3[j]) * (p2[i] - p1[i]);
}

template <class Real>
struct FlatTriangle {
  Real normal[3], distance;
  Real corner[3][2];
};
constexpr double kTriangleNearest = 1e-6, kTriangleFarthest = 1e7;

// A ray as triangle_hit.inc asks for it.
struct RayOfTriangle {
  const Vec3 &o, &d;
  double origin(int axis) const { return o[axis]; }
  double direction(int axis) const { return d[axis]; }
};

#include "tracer/shapes/mesh/triangle_hit.inc"

}  // namespace verisim::shapes
