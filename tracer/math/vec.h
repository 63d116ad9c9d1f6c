// Points, directions and matrices: Imath's double types under the names of the literature.
//
// Imath multiplies row vectors, p' = p * M, as POV-Ray's `matrix` does (translation in the fourth row).
#pragma once

#include <ImathBox.h>
#include <ImathMatrix.h>
#include <ImathVec.h>

#include <cmath>

namespace verisim {

using Vec2 = Imath::V2d;
using Vec3 = Imath::V3d;
using Mat4 = Imath::M44d;
using Box3 = Imath::Box3d;
using Box3f = Imath::Box3f;

inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }
// a / |a|, rounded as POV-Ray does it: chaotic walks of trace() end where its own do. A zero vector gives NaN, there,
// too.
inline Vec3 normalize(const Vec3& a) { return a * (1 / length(a)); }

// POV-Ray's generic "is zero" threshold (spec 03 section 0).
inline constexpr double kEpsilon = 1e-10;

struct Ray {
  Vec3 origin;
  Vec3 direction;  // unit length unless a function says otherwise
  Vec3 at(double t) const { return origin + t * direction; }
};

}  // namespace verisim
