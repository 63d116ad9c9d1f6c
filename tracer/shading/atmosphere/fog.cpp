#include "tracer/shading/atmosphere/fog.h"

#include "tracer/math/scaled.h"
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

// How much shorter turbulence makes each segment, as a share; it is asked for in their middles.
void shares_of_turbulence(const scene::Fog& fog, int generator, std::span<const FogSegment> segments, double* shares) {
  const scene::Turbulence& t = *fog.turbulence;
  PointBatch points;
  std::size_t place[PointBatch::kMax];
  int count = 0;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const auto& [ray, length, effect] = segments[k];
    shares[k] = std::exp(-length / fog.distance);
    if (shares[k] == 0) continue;  // as of rays that hit nothing
    const Vec3 middle = ray.origin + ray.direction * (length / 2);
    points.set(count, {middle.x * t.amount.x, middle.y * t.amount.y, middle.z * t.amount.z});
    place[count++] = k;
  }
  if (count == 0) return;
  points.fill_up(count);
  alignas(64) double values[PointBatch::kMax];
  textures::turbulence(generator, count, points, textures::Octaves(t.octaves, t.lambda, t.omega), values);
  for (int i = 0; i < count; ++i) shares[place[i]] *= std::min(1.0, values[i] * fog.turbulence_depth);
}

void pass_fog(const scene::Fog& fog, double share, FogSegment& segment) {
  const auto& [ray, length, effect] = segment;
  double density = 1;
  if (fog.type == 2) {
    const double start = dot(ray.origin, fog.up);
    density = ground_fog_density(start, start + length * dot(ray.direction, fog.up), fog.offset, fog.altitude);
  }
  const double width = length * (1 - share);
  const double clear = std::max<double>(std::exp(-width * density / fog.distance), fog.color.t);
  const Rgb filtered = fog.color.rgb() * fog.color.f;
  const double unfiltered = 1 - static_cast<double>(fog.color.f);
  segment.effect.clear *= clear * (Vec3(filtered.r, filtered.g, filtered.b) + Vec3(unfiltered));
  segment.effect.added += scaled(fog.color.rgb(), 1 - clear);
}

}  // namespace

void fog_along(std::span<const scene::Fog> fogs, int noise_generator, std::span<FogSegment> segments) {
  for (FogSegment& segment : segments) segment.effect = {};
  for (const scene::Fog& fog : fogs) {
    if (std::fabs(fog.distance) < kEpsilon || segments.empty()) continue;
    double shares[PointBatch::kMax] = {};
    if (fog.turbulence) shares_of_turbulence(fog, noise_generator, segments, shares);
    for (std::size_t k = 0; k < segments.size(); ++k) pass_fog(fog, shares[k], segments[k]);
  }
}

FogEffect fog_along(std::span<const scene::Fog> fogs, const Ray& ray, double length, int noise_generator) {
  FogSegment segment{ray, length};
  fog_along(fogs, noise_generator, std::span(&segment, 1));
  return segment.effect;
}

}  // namespace verisim::shading
