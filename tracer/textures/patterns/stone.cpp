// Patterns made of turbulence.
#include <numbers>

#include "tracer/textures/noise.h"
#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {

double sine_cycle(double v) { return std::sin(2 * std::numbers::pi * v); }

namespace {

double turbulence_of(const CompiledPattern& c, const Vec3& p) {
  return turbulence(p, c.turbulence.octaves, c.noise_generator);
}

}  // namespace

double agate(const CompiledPattern& c, const Vec3& p) {
  const double v = 0.5 * (1 + sine_cycle(1.3 * static_cast<double>(c.as<scene::AgateParams>().turbulence) * turbulence_of(c, p) + 1.1 * p.z));
  return v <= 0 ? 0 : std::pow(std::min(v, 1.0), 0.77);
}

double marble(const CompiledPattern& c, const Vec3& p) {
  const double amount = c.turbulence.amount.x;
  return amount == 0 ? p.x : p.x + amount * turbulence_of(c, p);
}

double wood(const CompiledPattern& c, const Vec3& p) {
  const TurbulenceStep& t = c.turbulence;
  if (!c.turbulent) return std::sqrt(p.x * p.x + p.y * p.y);
  const Vec3 v = vector_turbulence(p, t.octaves);
  const double x = p.x + sine_cycle((p.x + v.x) * t.amount.x);
  const double y = p.y + sine_cycle((p.y + v.y) * t.amount.y);
  return std::sqrt(x * x + y * y);
}

namespace {

// z + r + arms * (angle about z) / 2 pi + turbulence.
double spiral_phase(const CompiledPattern& c, const Vec3& p, double r) {
  double angle = 0;
  if (r != 0) {
    const double elevation = std::asin(std::clamp(p.y / r, -1.0, 1.0));
    angle = (p.x >= 0 ? 0.5 : 1.5) * std::numbers::pi + (p.x >= 0 ? elevation : -elevation);
  }
  const double arms = static_cast<std::int16_t>(c.as<scene::SpiralParams>().arms);
  const double v = p.z + r + arms * angle / (2 * std::numbers::pi);
  const double amount = c.turbulence.amount.x;
  return amount == 0 ? v : v + amount * turbulence_of(c, p);
}

}  // namespace

double spiral1(const CompiledPattern& c, const Vec3& p) { return spiral_phase(c, p, std::sqrt(p.x * p.x + p.y * p.y)); }

double spiral2(const CompiledPattern& c, const Vec3& p) {
  const double r = std::sqrt(p.x * p.x + p.y * p.y);
  return triangle(r) + triangle(spiral_phase(c, p, r));
}

}  // namespace verisim::textures
