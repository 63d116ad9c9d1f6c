// Patterns of distances and angles.
#include <numbers>

#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {
namespace {

double falling_from_one(double distance) { return distance > 1 ? 0 : 1 - distance; }

}  // namespace

namespace formulas {

double boxed(const CompiledPattern&, const Vec3& p, const SurfacePoint*) {
  return falling_from_one(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}));
}
double cylindrical(const CompiledPattern&, const Vec3& p, const SurfacePoint*) {
  return falling_from_one(std::sqrt(p.x * p.x + p.z * p.z));
}
double planar(const CompiledPattern&, const Vec3& p, const SurfacePoint*) { return falling_from_one(std::fabs(p.y)); }
double spherical(const CompiledPattern&, const Vec3& p, const SurfacePoint*) { return falling_from_one(length(p)); }
double onion(const CompiledPattern&, const Vec3& p, const SurfacePoint*) { return std::fmod(length(p), 1.0); }

double leopard(const CompiledPattern&, const Vec3& p, const SurfacePoint*) {
  const double v = (std::sin(p.x) + std::sin(p.y) + std::sin(p.z)) / 3;
  return v * v;
}

double radial(const CompiledPattern&, const Vec3& p, const SurfacePoint*) {
  if (std::fabs(p.x) < 0.001 && std::fabs(p.z) < 0.001) return 0.25;
  return 0.25 + (std::atan2(p.x, p.z) + std::numbers::pi) / (2 * std::numbers::pi);
}

double gradient(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  const double v = dot(p, c.as<GradientData>().unit);
  return v > 1 ? std::fmod(v, 1.0) : v;
}

}  // namespace formulas
}  // namespace verisim::textures
