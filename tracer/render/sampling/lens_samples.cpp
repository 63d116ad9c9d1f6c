// Samples of a camera with a lens: the lens rays of several samples are traced together, in step.
#include <algorithm>

#include "tracer/render/sampling/pixel_sampler.h"

namespace verisim::render {

std::optional<Color> PixelSampler::lens_ray(const Vec2& place, int number) {
  const std::optional<PrimaryRay> primary = camera_.blur->ray(camera_.rays, place.x, place.y, number);
  if (!primary) return std::nullopt;
  tracer_.random().begin_sample(place.x, place.y, static_cast<std::uint32_t>(number));
  return trace(primary->ray, primary->image);
}

Color PixelSampler::lens_sample(const Vec2& place) {
  FocalBlur::Average average(*camera_.blur);
  while (!average.complete()) average.add(lens_ray(place, average.known()));
  return average.mean();
}

// Those at the wavefront's places: what each of them wants before its next test makes wavefronts.
void PixelSampler::lens_points(int count, Color* colors) {
  tracer_.statistics().samples += static_cast<std::uint64_t>(count);
  Lens& lens = lens_;
  std::copy_n(wavefront_.places(), count, lens.places);
  lens.averages.assign(static_cast<std::size_t>(count), FocalBlur::Average(*camera_.blur));
  for (int i = 0, one = 1; i < count; ++i) lens.entries[i] = entry(lens.places[i].x, lens.places[i].y, one);
  for (;;) {
    lens.rays.clear();
    for (int i = 0; i < count; ++i) {
      const FocalBlur::Average& average = lens.averages[static_cast<std::size_t>(i)];
      for (int n = average.known(); !average.complete() && n < average.wanted(); ++n) lens.rays.push_back({i, n});
    }
    if (lens.rays.empty()) break;
    for (std::size_t done = 0; done < lens.rays.size(); done += shading::Wavefront::kMax)
      lens_wavefront(
          std::span(lens.rays).subspan(done, std::min<std::size_t>(lens.rays.size() - done, shading::Wavefront::kMax)));
  }
  for (int i = 0; i < count; ++i) colors[i] = lens.averages[static_cast<std::size_t>(i)].mean();
}

void PixelSampler::lens_wavefront(std::span<const LensRay> rays) {
  const accel::WorldEntry* entries[shading::Wavefront::kMax];
  for (std::size_t k = 0; k < rays.size(); ++k) {
    wavefront_.places()[k] = lens_.places[rays[k].sample];
    wavefront_.numbers()[k] = static_cast<std::uint32_t>(rays[k].number);
    entries[k] = lens_.entries[rays[k].sample];
  }
  const auto count = static_cast<int>(rays.size());
  camera_.blur->rays(camera_.rays, wavefront_.places(), wavefront_.numbers(), count, wavefront_.packet().rays);
  bool together = true;
  for (int k = 0; k < count && together; ++k) together = starts_like_the_first(k);
  Color seen[shading::Wavefront::kMax];
  if (together) wavefront_.trace(count, entries, seen);
  for (std::size_t k = 0; k < rays.size(); ++k)
    lens_.averages[static_cast<std::size_t>(rays[k].sample)].add(
        together ? std::optional(seen[k]) : lens_ray(lens_.places[rays[k].sample], rays[k].number));
}

}  // namespace verisim::render
