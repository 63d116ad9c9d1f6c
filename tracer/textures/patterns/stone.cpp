// Spirals, and what patterns made of turbulence share; agate, marble and wood themselves are in evaluation.inc.
#include <numbers>

#include "tracer/noise/noise.h"
#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {

double sine_cycle(double v) { return std::sin(sine_angle(v)); }

namespace {

double turbulence_of(const CompiledPattern& c, const Vec3& p) {
  return turbulence(p, c.turbulence->octaves, c.noise_generator);
}

// z + r + arms * (angle about z) / 2 pi + turbulence.
double spiral_phase(const CompiledPattern& c, const Vec3& p, double r) {
  double angle = 0;
  if (r != 0) {
    const double elevation = std::asin(std::clamp(p.y / r, -1.0, 1.0));
    angle = (p.x >= 0 ? 0.5 : 1.5) * std::numbers::pi + (p.x >= 0 ? elevation : -elevation);
  }
  const double arms = static_cast<std::int16_t>(c.as<scene::SpiralParams>().arms);
  const double v = p.z + r + arms * angle / (2 * std::numbers::pi);
  const double amount = c.turbulence->amount.x;
  return amount == 0 ? v : v + amount * turbulence_of(c, p);
}

}  // namespace

double formulas::spiral1(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  return spiral_phase(c, p, std::sqrt(p.x * p.x + p.y * p.y));
}

double formulas::spiral2(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  const double r = std::sqrt(p.x * p.x + p.y * p.y);
  return triangle(r) + triangle(spiral_phase(c, p, r));
}

}  // namespace verisim::textures
