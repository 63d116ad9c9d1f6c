// Where a ray runs inside a light's cone or cylinder (spec 07 4.5).
#include <algorithm>

#include "tracer/math/constants.h"
#include "tracer/media/media.h"

namespace verisim::global {
namespace {

constexpr double kFar = 1e7;

// Roots t1 <= t2 of a t^2 + 2 b t + c = 0 by POV-Ray's thresholds; the number of roots.
int roots(double a, double b, double c, double& t1, double& t2) {
  if (a == 0.0) return 0;
  const double d = b * b - a * c;
  if (d > kEpsilon) {
    const double s = std::sqrt(d);
    t1 = (-b - s) / a, t2 = (-b + s) / a;
    if (t1 > t2) std::swap(t1, t2);
    return 2;
  }
  if (d > -kEpsilon) {
    t1 = t2 = -b / a;
    return 1;
  }
  return 0;
}

bool cone_range(const scene::LightSource& light, const Ray& ray, double& t1, double& t2) {
  const Vec3 v = ray.origin - light.position;
  const double k1 = dot(ray.direction, light.direction), k2 = dot(v, light.direction);
  if (k1 <= 0.0 && k2 < 0.0) return false;
  const double cosine = std::cos(light.falloff * kDegree), m = 1.0 / (cosine * cosine);
  if (roots(1.0 - k1 * k1 * m, dot(v, ray.direction) - k1 * k2 * m, dot(v, v) - k2 * k2 * m, t1, t2) == 0) return false;
  const bool behind1 = k2 + t1 * k1 <= 0.0, behind2 = k2 + t2 * k1 <= 0.0;
  if (behind1 && behind2) return false;
  if (behind1 || behind2) {
    // Only one root lies on the real nappe: the ray enters or leaves the cone once.
    const double t = behind1 ? t2 : t1;
    const bool inside = k2 > 0.0 && k2 * k2 * m >= dot(v, v);
    if (inside) {
      t1 = 0.0, t2 = t > 0.0 ? t : kFar;
    } else {
      t1 = t, t2 = kFar;
    }
  }
  return true;
}

bool cylinder_range(const scene::LightSource& light, const Ray& ray, double& t1, double& t2) {
  const Vec3 v = ray.origin - light.position;
  const double k1 = dot(ray.direction, light.direction), k2 = dot(v, light.direction);
  const double a = 1.0 - k1 * k1;
  if (a < kEpsilon) return false;
  if (roots(a, dot(v, ray.direction) - k1 * k2, dot(v, v) - k2 * k2 - light.falloff * light.falloff, t1, t2) == 0)
    return false;
  // POV-Ray lets an end behind the light be the ray's origin, not the crossing of the light's plane: a ray that comes
  // towards the light and leaves the cylinder behind it is not lit at all.
  const double z1 = k2 + t1 * k1, z2 = k2 + t2 * k1;
  if ((z1 <= 0.0 && z2 <= 0.0) || (z1 > kFar && z2 > kFar)) return false;
  const auto clip = [&](double& t, double z) {
    if (z <= 0.0) t = 0.0;
    if (z > kFar) t = (kFar - k2) / k1;
  };
  clip(t1, z1), clip(t2, z2);
  return true;
}

}  // namespace

bool lit_range(const scene::LightSource& light, const Ray& ray, double length, double& first, double& last) {
  double t1 = 0.0, t2 = length;
  if (light.kind == scene::LightKind::spotlight && !cone_range(light, ray, t1, t2)) return false;
  if (light.kind == scene::LightKind::cylinder && !cylinder_range(light, ray, t1, t2)) return false;
  if (light.kind == scene::LightKind::spotlight || light.kind == scene::LightKind::cylinder) {
    if (!(t1 < length && t2 > 0.001)) return false;
  }
  first = std::max(t1, 0.0), last = std::min(t2, length);
  return true;
}

}  // namespace verisim::global
