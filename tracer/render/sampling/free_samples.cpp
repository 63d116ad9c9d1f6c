// Samples of a camera whose rays are not linear in the position: several rays, one or none for each, which are traced
// together however they lie.
#include <algorithm>
#include <cmath>

#include "tracer/render/sampling/pixel_sampler.h"

namespace verisim::render {
namespace {

constexpr Color kNoRay{0, 0, 0, 0, 1};

}  // namespace

Color PixelSampler::free_sample(const Vec2& place) {
  Color sum;
  int shot = 0;
  for (int k = 0; k < camera_.rays_per_sample(); ++k) {
    const std::optional<Ray> ray = camera_.ray(place.x, place.y, k);
    if (!ray) continue;
    tracer_.random().begin_sample(place.x, place.y, static_cast<std::uint32_t>(k));
    sum += tracer_.trace_camera(*ray, starts_differ_, camera_.limit());
    ++shot;
  }
  return shot > 0 ? sum * (1.0f / static_cast<float>(shot)) : kNoRay;
}

// Those at the wavefront's places.
void PixelSampler::free_points(int count, Color* colors) {
  if (camera_.limit() < accel::kFarthestHit) return one_by_one(count, colors);
  tracer_.statistics().samples += static_cast<std::uint64_t>(count);
  Vec2 places[shading::Wavefront::kMax];
  std::copy_n(wavefront_.places(), count, places);
  int shot[shading::Wavefront::kMax] = {};
  FreeRay rays[shading::Wavefront::kMax];
  std::size_t waiting = 0;
  for (int i = 0; i < count; ++i) {
    colors[i] = {};
    for (int k = 0; k < camera_.rays_per_sample(); ++k) {
      const std::optional<Ray> ray = camera_.ray(places[i].x, places[i].y, k);
      if (!ray) continue;
      rays[waiting++] = {*ray, i, k};
      ++shot[i];
      if (waiting < std::size(rays)) continue;
      free_wavefront(rays, places, colors);
      waiting = 0;
    }
  }
  free_wavefront(std::span(rays).first(waiting), places, colors);
  for (int i = 0; i < count; ++i) colors[i] = shot[i] > 0 ? colors[i] * (1.0f / static_cast<float>(shot[i])) : kNoRay;
}

// Adds the rays' colours to the sums of their samples.
void PixelSampler::free_wavefront(std::span<const FreeRay> rays, const Vec2* places, Color* sums) {
  if (rays.empty()) return;
  RayBatch& batch = wavefront_.packet().rays;
  bool together = true;
  for (std::size_t k = 0; k < rays.size() && together; ++k) {
    const int lane = static_cast<int>(k);
    batch.origin.set(lane, rays[k].ray.origin), batch.direction.set(lane, rays[k].ray.direction);
    wavefront_.places()[k] = places[rays[k].sample],
    wavefront_.numbers()[k] = static_cast<std::uint32_t>(rays[k].number);
    together = starts_like_the_first(lane);
  }
  Color seen[shading::Wavefront::kMax];
  const accel::WorldEntry* const unknown[shading::Wavefront::kMax] = {};
  if (together) wavefront_.trace(static_cast<int>(rays.size()), unknown, seen);
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto& [ray, sample, number] = rays[k];
    if (!together) {
      tracer_.random().begin_sample(places[sample].x, places[sample].y, static_cast<std::uint32_t>(number));
      seen[k] = tracer_.trace_camera(ray, starts_differ_);
    }
    sums[sample] += seen[k];
  }
}

}  // namespace verisim::render
