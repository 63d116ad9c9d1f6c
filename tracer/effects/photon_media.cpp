#include "tracer/effects/photon_media.h"

#include <algorithm>

namespace verisim::global {
namespace {

class NoLight : public MediaEnvironment {
 public:
  explicit NoLight(shading::Tracer& tracer) : tracer_(tracer) {}
  double random() override { return tracer_.random().media(); }
  std::span<const scene::LightSource* const> lights() override { return {}; }
  Rgb illumination(std::size_t, const Vec3&, Vec3&) override { return {}; }

 private:
  shading::Tracer& tracer_;
};

using MediaSpan = std::span<const CompiledMedia* const>;

int most_intervals(MediaSpan media) {
  int n = 1;
  for (const CompiledMedia* m : media) n = std::max(n, m->description->intervals);
  return n;
}

}  // namespace

void ScenePhotonMedia::segment(shading::Tracer& tracer, const shading::RayState& ray, double length, double path,
                               bool deposit, const shading::PhotonShot& shot, Rgb& packet,
                               std::vector<shading::StoredPhoton>& stored) const {
  MediaList media;
  effects_.collect(tracer.interiors(ray.interiors), media);
  const std::size_t in_containers = media.size();
  for (const CompiledMedia* m : effects_.atmosphere_list()) media.push_back(m);
  if (media.empty()) return;
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
  NoLight environment(tracer);
  packet *= passed * integrate(attenuating, ray.ray, length, true, environment).transmittance;
}

Rgb ScenePhotonMedia::deposit_along(shading::Tracer& tracer, MediaSpan media, const Ray& ray, double length,
                                    double path, const shading::PhotonShot& shot, const Rgb& packet,
                                    std::vector<shading::StoredPhoton>& stored) const {
  const scene::Photons& settings = effects_.scene().settings.photons;
  const bool parallel = shot.light->parallel;
  const int intervals = most_intervals(media);
  const double interval = length / intervals;
  double step = shot.sigma * (parallel ? 1.0 : path) * settings.media_factor;
  auto count = static_cast<long>(step > 0.0 ? std::min(interval / step, 1e9) : 0.0);
  if (count > settings.media_count) count = settings.media_count, step = interval / static_cast<double>(count);
  // Depth is measured where photons are left; what leaves none on its way through is lost.
  if (count == 0) return {};
  const double factor = parallel || path <= 0.0 ? step / shot.sigma : step / (shot.sigma * path);
  Rgb extinction;
  for (int i = 0; i < intervals; ++i) {
    for (long j = 0; j < count; ++j) {
      const double at = (static_cast<double>(j) + 0.5 + (tracer.random().media() - 0.5) * settings.jitter) /
                        static_cast<double>(count);
      const double distance = (i + at) * interval, travelled = path + distance;
      const double share = factor * shot.sigma * (parallel ? 1.0 : travelled) * shot.area_factor(travelled);
      const Vec3 p = ray.at(distance);
      stored.push_back({p, -ray.direction, packet * static_cast<float>(share), true});
      for (const CompiledMedia* m : media) extinction += media_density(*m, p) * m->extinction;
    }
  }
  const Rgb depth = extinction * static_cast<float>(interval / static_cast<double>(count));
  return {std::exp(-depth.r), std::exp(-depth.g), std::exp(-depth.b)};
}

}  // namespace verisim::global
