#include "tracer/global/photon_media.h"

#include <algorithm>

namespace verisim::global {

void ScenePhotonMedia::segment(shading::Tracer& tracer, const shading::RayState& ray, double length, double path, bool deposit,
                               const shading::PhotonShot& shot, Rgb& packet, std::vector<shading::StoredPhoton>& stored) const {
  MediaList media;
  effects_.collect(tracer.interiors(ray.interiors), media);
  const std::size_t in_containers = media.size();
  for (const CompiledMedia* m : effects_.atmosphere_list()) media.push_back(m);
  if (media.empty()) return;
  const std::span<const CompiledMedia* const> active{media.data(), media.size()};

  // Atmospheric media never receive photons, nor do media that only emit.
  const scene::Photons& settings = effects_.scene().settings.photons;
  const auto containers = active.first(in_containers);
  const bool scatters = std::any_of(containers.begin(), containers.end(), [](const CompiledMedia* m) { return m->scatters; });
  const bool collects = std::any_of(containers.begin(), containers.end(), [](const CompiledMedia* m) { return m->description->collect; });
  if (deposit && settings.media_count > 0 && scatters && collects) {
    const bool parallel = shot.light->parallel;
    double step = shot.sigma * (parallel ? 1.0 : path) * settings.media_factor;
    auto count = static_cast<long>(step > 0.0 ? std::min(length / step, 1e9) : 0.0);
    if (count > settings.media_count) count = settings.media_count, step = length / static_cast<double>(count);
    const double factor = parallel || path <= 0.0 ? step / shot.sigma : step / (shot.sigma * path);
    for (long j = 0; j < count; ++j) {
      const double at = (static_cast<double>(j) + 0.5 + (tracer.random().media() - 0.5) * settings.jitter) / static_cast<double>(count);
      const double travelled = path + at * length;
      const double share = factor * shot.sigma * (parallel ? 1.0 : travelled) * shot.area_factor(travelled);
      stored.push_back({ray.ray.at(at * length), -ray.ray.direction, packet * static_cast<float>(share), true});
    }
  }
  class NoLight : public MediaEnvironment {
   public:
    explicit NoLight(shading::Tracer& t) : tracer(t) {}
    double random() override { return tracer.random().media(); }
    std::span<const scene::LightSource* const> lights() override { return {}; }
    Rgb illumination(std::size_t, const Vec3&, Vec3&) override { return {}; }
    shading::Tracer& tracer;
  } environment(tracer);
  packet *= integrate(active, ray.ray, length, true, environment).transmittance;
}

}  // namespace verisim::global
