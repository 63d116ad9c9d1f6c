// Patterns that look at the surface: slope and angle of incidence.
#include <numbers>

#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {
namespace {

double into_range(double v, double low, double width) { return width == 0 ? v : (v - low) / width; }

// The fractional part; 1 itself stays just below 1.
double wrap(double v) {
  if (v == 1) return 1 - kEpsilon;
  return v < 0 ? 1 + std::fmod(v, 1.0) : std::fmod(v, 1.0);
}

}  // namespace

double formulas::slope(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface) {
  if (!surface || !surface->is_hit) return 0;
  const SlopeData& s = c.as<SlopeData>();
  Vec3 direction = s.direction;
  if (s.point_at) direction = normalize(s.direction - surface->point);
  const double cosine = std::clamp(dot(surface->normal, direction), -1.0, 1.0);
  double v = into_range(0.5 + std::asin(cosine) / std::numbers::pi, s.slope_low, s.slope_width);
  if (!s.has_altitude) return wrap(s.slope_weight * v);
  const double height = into_range(dot(p, s.altitude), s.altitude_low, s.altitude_width);
  v = s.slope_weight * v + (1 - s.slope_weight) * height;
  if (v >= 1 && v < 1 + kEpsilon) return v - kEpsilon;
  return v < 0 ? 1 + std::fmod(v, 1.0) : std::fmod(v, 1.0);
}

double formulas::aoi(const CompiledPattern&, const Vec3&, const SurfacePoint* surface) {
  if (!surface || !surface->is_hit) return 0;
  return std::acos(std::clamp(dot(normalize(surface->normal), normalize(surface->ray_direction)), -1.0, 1.0)) /
         std::numbers::pi;
}

}  // namespace verisim::textures
