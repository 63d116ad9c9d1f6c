#include "tracer/shading/atmosphere/fog.h"

#include "tracer/noise/noise.h"

namespace verisim::shading {

double ground_fog_density(double start_height, double end_height, double offset, double altitude) {
  const double s = (start_height - offset) / altitude, e = (end_height - offset) / altitude;
  if (s <= 0 && e <= 0) return 1;
  if (s <= 0) return (std::atan(e) - s) / (e - s);
  if (e <= 0) return (std::atan(s) - e) / (s - e);
  if (std::fabs(s - e) < kEpsilon) return 1 / (s * s + 1);
  return (std::atan(s) - std::atan(e)) / (s - e);
}

FogEffect fog_along(std::span<const scene::Fog> fogs, const Vec3& origin, const Vec3& direction, double length,
                    int noise_generator) {
  FogEffect total;
  for (const scene::Fog& fog : fogs) {
    if (std::fabs(fog.distance) < kEpsilon) continue;
    double density = 1, width = length;
    if (fog.type == 2) {
      const double start = dot(origin, fog.up);
      density = ground_fog_density(start, start + length * dot(direction, fog.up), fog.offset, fog.altitude);
    }
    if (fog.turbulence) {
      const Vec3 middle = origin + direction * (length / 2);
      const Vec3 q(middle.x * fog.turbulence->amount.x, middle.y * fog.turbulence->amount.y,
                   middle.z * fog.turbulence->amount.z);
      const double t = textures::turbulence(q, fog.turbulence->octaves, fog.turbulence->lambda, fog.turbulence->omega,
                                            noise_generator);
      width = length * (1 - std::exp(-length / fog.distance) * std::min(1.0, t * fog.turbulence_depth));
    }
    const auto clear = std::max(static_cast<float>(std::exp(-width * density / fog.distance)), fog.color.t);
    const Rgb tint = fog.color.rgb() * fog.color.f + Rgb(1 - fog.color.f);
    total.passed *= tint * clear;
    total.added += fog.color.rgb() * (1 - clear);
  }
  return total;
}

}  // namespace verisim::shading
