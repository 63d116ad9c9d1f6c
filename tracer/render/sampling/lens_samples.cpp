// Samples of a camera with a lens: the lens rays of several samples are traced together, in step.
#include <algorithm>

#include "tracer/render/sampling/pixel_sampler.h"

namespace verisim::render {
namespace {

// While it lives, camera rays are as hollow as those before them were.
class LensIsHollow {
 public:
  LensIsHollow(shading::Tracer& tracer, bool so_far) : lens_(tracer.lens_is_hollow()) { lens_ = so_far; }
  ~LensIsHollow() { lens_ = true; }
  LensIsHollow(const LensIsHollow&) = delete;
  LensIsHollow& operator=(const LensIsHollow&) = delete;

 private:
  bool& lens_;
};

// Whether anything shows that a ray started in what is not hollow: else all are taken for hollow, and go together.
bool hollow_shows(const shading::SceneData& scene) { return scene.air_shows() || scene.any_media(); }

}  // namespace

std::optional<Color> PixelSampler::lens_ray(const Vec2& place, int number, bool& hollow) {
  const std::optional<PrimaryRay> primary = camera_.blur->ray(camera_.rays, place.x, place.y, number);
  if (!primary) return std::nullopt;
  tracer_.random().begin_sample(place.x, place.y, static_cast<std::uint32_t>(number));
  const LensIsHollow scope(tracer_, hollow);
  if (hollow_shows(tracer_.scene())) hollow = tracer_.camera_state(primary->ray, starts_differ_).hollow;
  return tracer_.trace_camera(camera_.bent(primary->ray, primary->image), starts_differ_);
}

Color PixelSampler::lens_sample(const Vec2& place) {
  FocalBlur::Average average(*camera_.blur);
  for (bool hollow = true; !average.complete();) average.add(lens_ray(place, average.known(), hollow));
  return average.mean();
}

// Those at the wavefront's places: what each of them wants before its next test makes wavefronts.
void PixelSampler::lens_points(int count, Color* colors) {
  tracer_.statistics().samples += static_cast<std::uint64_t>(count);
  Lens& lens = lens_;
  std::copy_n(wavefront_.places(), count, lens.places);
  lens.averages.assign(static_cast<std::size_t>(count), FocalBlur::Average(*camera_.blur));
  std::fill_n(lens.hollow, count, true);
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
  const bool so_far = lens_.hollow[rays[0].sample];
  bool together = true, hollow = so_far;
  for (int k = 0; k < count && together; ++k)
    together = lens_.hollow[rays[static_cast<std::size_t>(k)].sample] == so_far && starts_like_the_first(k);
  Color seen[shading::Wavefront::kMax];
  if (together) {
    const LensIsHollow scope(tracer_, so_far);
    if (hollow_shows(tracer_.scene())) hollow = tracer_.camera_state(wavefront_.packet().rays.at(0), false).hollow;
    wavefront_.trace(count, entries, seen);
  }
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto& [sample, number] = rays[k];
    if (together) lens_.hollow[sample] = hollow;
    lens_.averages[static_cast<std::size_t>(sample)].add(
        together ? std::optional(seen[k]) : lens_ray(lens_.places[sample], number, lens_.hollow[sample]));
  }
}

}  // namespace verisim::render
