// The iteration of a Julia fractal at several points of a ray, or of a row of rays, at once. Every lane does what the plain code of julia_fractal.cpp does, operation by
// operation, so the results are the same to the last bit whatever the machine's vectors.
#pragma once

#include "tracer/shapes/julia_algebra.h"

namespace verisim::shapes::julia {

inline constexpr int kLanes = 8;

enum class Kind : unsigned char { quaternion_square, quaternion_cube, hypercomplex_square, other };

// What the iteration needs to know of a fractal.
struct Field {
  Kind kind = Kind::quaternion_square;
  Number parameter;
  Vec3 slice;
  double slice_w = 1, slice_distance = 0;
  double escape = 4;     // |h|^2 beyond which a point is outside
  double precision = 0.05;  // the smallest step
  int iterations = 20;
  bool doubled = false;  // hypercomplex: the estimates of `sqr` have a factor 2^M
};

// Points origin + t * direction. Bit k: t[k] survives all iterations. Not for Kind::other.
unsigned inside_lanes(const Field& field, const Vec3& origin, const Vec3& direction, const double t[kLanes]);
// The same, and how far the ray may go from each point (spec 04 section 8, step estimates): exact where above the precision, else anything not above it.
unsigned march_lanes(const Field& field, const Vec3& origin, const Vec3& direction, const double t[kLanes], double estimate[kLanes]);

// A ray a lane, in the fractal's space, directions of unit length.
struct alignas(64) Rays {
  double origin[3][kLanes], direction[3][kLanes];
  void set(int lane, const Vec3& o, const Vec3& d) {
    for (int i = 0; i < 3; ++i) origin[i][lane] = o[i], direction[i][lane] = d[i];
  }
};

// march_lanes for the points at distances t of the rays that `asked` names; estimates only for those of `estimated`.
unsigned march_rays(const Field& field, const Rays& rays, const double t[kLanes], unsigned asked, unsigned estimated, double estimate[kLanes]);

}  // namespace verisim::shapes::julia
