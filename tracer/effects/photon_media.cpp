#include "tracer/effects/photon_media.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <limits>

#include "tracer/media/media_mixture.h"

namespace verisim::global {
namespace {

// Lights cut the way of a packet in pieces, but what media scatter of their light is not added to it.
class UnlitSurroundings : public MediaEnvironment {
 public:
  explicit UnlitSurroundings(shading::Tracer& tracer) : tracer_(tracer) {}
  double random() override { return tracer_.random().media(); }
  bool replay() const override { return tracer_.random().replay(); }
  std::span<const scene::LightSource* const> lights() override {
    sources_.clear();
    const shading::SceneData& scene = tracer_.scene();
    for (std::size_t i = 0; i < scene.global_lights(); ++i) {
      const scene::LightSource& source = scene.lights()[i].source();
      if (shines_on_media(source)) sources_.push_back(&source);
    }
    return {sources_.data(), sources_.size()};
  }
  Rgb illumination(std::size_t, const Vec3&, Vec3&) override { return {}; }

 private:
  shading::Tracer& tracer_;
  boost::container::small_vector<const scene::LightSource*, 16> sources_;
};

using MediaSpan = std::span<const CompiledMedia* const>;

}  // namespace

void ScenePhotonMedia::segment(shading::Tracer& tracer, const shading::RayState& ray, double length, double path,
                               bool deposit, const shading::PhotonShot& shot, Rgb& packet,
                               std::vector<shading::StoredPhoton>& stored) const {
  MediaList media;
  effects_.collect(tracer.interiors(ray.interiors), media);
  const std::size_t in_containers = media.size();
  for (const CompiledMedia* m : effects_.atmosphere_list()) media.push_back(m);
  // Media that only emit are looked at beside others alone.
  if (std::ranges::all_of(media, [](const CompiledMedia* m) { return m->extinction == Rgb() && !m->scatters; })) return;
  MediaSpan attenuating{media.data(), media.size()};

  // Atmospheric media never receive photons, nor do media that only emit.
  const MediaSpan containers = attenuating.first(in_containers);
  const bool scatters =
      std::any_of(containers.begin(), containers.end(), [](const CompiledMedia* m) { return m->scatters; });
  const bool collects =
      std::any_of(containers.begin(), containers.end(), [](const CompiledMedia* m) { return m->description->collect; });
  Rgb passed(1.0f);
  if (deposit && effects_.scene().settings.photons.media_count > 0 && scatters && collects) {
    passed = deposit_along(tracer, containers, ray.ray, length, path, shot, packet, stored);
    attenuating = attenuating.subspan(in_containers);
  }
  UnlitSurroundings environment(tracer);
  const MediaResult result = integrate(attenuating, ray.ray, length, false, environment);
  packet = packet * (passed * result.transmittance) + result.emission;
}

Rgb ScenePhotonMedia::deposit_along(shading::Tracer& tracer, MediaSpan media, const Ray& ray, double length,
                                    double path, const shading::PhotonShot& shot, const Rgb& packet,
                                    std::vector<shading::StoredPhoton>& stored) const {
  const scene::Photons& settings = effects_.scene().settings.photons;
  const bool parallel = shot.light->parallel;
  MediaIntervals intervals;
  intervals.look_for_lights(UnlitSurroundings(tracer).lights(), ray, length);
  intervals.divide(MediaMixture(media), length);
  Rgb depth;
  for (const MediaInterval& interval : intervals.all()) {
    double step = shot.sigma * (parallel ? 1.0 : path) * settings.media_factor;
    auto count = static_cast<long>(step > 0.0 ? std::min(interval.length / step, 1e9) : 0.0);
    if (count > settings.media_count) count = settings.media_count, step = interval.length / static_cast<double>(count);
    // Depth is measured where photons are left; of what leaves none on its way nothing is known.
    if (count == 0) {
      depth = Rgb(std::numeric_limits<float>::quiet_NaN());
      continue;
    }
    const double factor = parallel || path <= 0.0 ? step / shot.sigma : step / (shot.sigma * path);
    Rgb extinction;
    for (long j = 0; j < count; ++j) {
      const double at = (static_cast<double>(j) + 0.5 + (tracer.random().media() - 0.5) * settings.jitter) /
                        static_cast<double>(count);
      const double distance = interval.start + at * interval.length, travelled = path + distance;
      const double share = factor * shot.sigma * (parallel ? 1.0 : travelled) * shot.area_factor(travelled);
      const Vec3 p = ray.at(distance);
      stored.push_back({p, -ray.direction, packet * static_cast<float>(share), true});
      for (const CompiledMedia* m : media) extinction += media_density(*m, p) * m->extinction;
    }
    depth += extinction * static_cast<float>(interval.length / static_cast<double>(count));
  }
  return {std::exp(-depth.r), std::exp(-depth.g), std::exp(-depth.b)};
}

}  // namespace verisim::global
