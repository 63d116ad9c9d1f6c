#include "tracer/shading/atmosphere/fog.h"

#include "tracer/noise/noise.h"
#include "tracer/textures/point_batch.h"

namespace verisim::shading {

double ground_fog_density(double start_height, double end_height, double offset, double altitude) {
  const double s = (start_height - offset) / altitude, e = (end_height - offset) / altitude;
  if (s <= 0 && e <= 0) return 1;
  if (s <= 0) return (std::atan(e) - s) / (e - s);
  if (e <= 0) return (std::atan(s) - e) / (s - e);
  if (std::fabs(s - e) < kEpsilon) return 1 / (s * s + 1);
  return (std::atan(s) - std::atan(e)) / (s - e);
}

namespace {

using textures::PointBatch;

// The turbulence in the middles of the segments.
void turbulence_along(const scene::Turbulence& t, int generator, std::span<const FogSegment> segments, double* values) {
  PointBatch points;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Vec3 middle = segments[k].ray.origin + segments[k].ray.direction * (segments[k].length / 2);
    points.set(static_cast<int>(k), {middle.x * t.amount.x, middle.y * t.amount.y, middle.z * t.amount.z});
  }
  const auto count = static_cast<int>(segments.size());
  points.fill_up(count);
  textures::turbulence(generator, count, points, textures::Octaves(t.octaves, t.lambda, t.omega), values);
}

void pass_fog(const scene::Fog& fog, const double* turbulence, FogSegment& segment) {
  const auto& [ray, length, effect] = segment;
  double density = 1, width = length;
  if (fog.type == 2) {
    const double start = dot(ray.origin, fog.up);
    density = ground_fog_density(start, start + length * dot(ray.direction, fog.up), fog.offset, fog.altitude);
  }
  if (turbulence)
    width = length * (1 - std::exp(-length / fog.distance) * std::min(1.0, *turbulence * fog.turbulence_depth));
  const auto clear = std::max(static_cast<float>(std::exp(-width * density / fog.distance)), fog.color.t);
  const Rgb tint = fog.color.rgb() * fog.color.f + Rgb(1 - fog.color.f);
  segment.effect.passed *= tint * clear;
  segment.effect.added += fog.color.rgb() * (1 - clear);
}

}  // namespace

void fog_along(std::span<const scene::Fog> fogs, int noise_generator, std::span<FogSegment> segments) {
  for (FogSegment& segment : segments) segment.effect = {};
  for (const scene::Fog& fog : fogs) {
    if (std::fabs(fog.distance) < kEpsilon || segments.empty()) continue;
    alignas(64) double turbulence[PointBatch::kMax];
    if (fog.turbulence) turbulence_along(*fog.turbulence, noise_generator, segments, turbulence);
    for (std::size_t k = 0; k < segments.size(); ++k)
      pass_fog(fog, fog.turbulence ? turbulence + k : nullptr, segments[k]);
  }
}

FogEffect fog_along(std::span<const scene::Fog> fogs, const Ray& ray, double length, int noise_generator) {
  FogSegment segment{ray, length};
  fog_along(fogs, noise_generator, std::span(&segment, 1));
  return segment.effect;
}

}  // namespace verisim::shading
