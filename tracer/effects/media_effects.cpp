// Media in the recursive trace: which media act on a segment, and the light they see (spec 07 sections 4.2, 4.4, 4.7).
#include <boost/container/small_vector.hpp>

#include "tracer/effects/effects_state.h"
#include "tracer/math/constants.h"
#include "tracer/media/media_batch.h"

namespace verisim::global {

namespace {

class MediaSurroundings : public MediaEnvironment {
 public:
  MediaSurroundings(const SceneEffects& effects, const PhotonMap* photons, shading::Tracer& tracer,
                    const shading::RayState& ray, const shapes::Surface* end)
      : effects_(effects), photons_(photons), tracer_(tracer), ray_(ray), end_(end) {}

  double random() override { return tracer_.random().media(); }
  bool replay() const override { return tracer_.random().replay(); }

  std::span<const scene::LightSource* const> lights() override {
    sources_.clear(), lights_.clear();
    const auto add = [&](const shading::Light& light) {
      if (!shines_on_media(light.source())) return;
      sources_.push_back(&light.source()), lights_.push_back(&light);
    };
    const shading::SceneData& scene = tracer_.scene();
    if (!end_ || !end_->ignore_global_lights) {
      for (std::size_t i = 0; i < scene.global_lights(); ++i) add(scene.lights()[i]);
    }
    if (end_) {
      for (const scene::LightSource* source : end_->group_lights()) add(scene.light_of(source));
    }
    return {sources_.data(), sources_.size()};
  }

  Rgb illumination(std::size_t light, const Vec3& p, Vec3& to_light) override {
    return tracer_.light_at(*lights_[light], p, ray_, true, to_light);
  }

  NearbyPhotons photons(const Vec3& p) override {
    if (!photons_ || photons_->empty()) return {};
    EffectsStateOfScene& state = EffectsStateOfScene::of(tracer_);
    const scene::Photons& s = effects_.scene().settings.photons;
    PhotonMap::Gathered& gathered = photons_ == &effects_.media_photons() ? state.gathered_in_media : state.gathered;
    photons_->gather(p, nullptr, {s.gather_min, s.gather_max, s.expand_increase, s.expand_min}, gathered);
    const double r = gathered.radius;
    return {gathered.photons, static_cast<float>(3.0 / (4.0 * kPi * r * r * r))};
  }

 private:
  const SceneEffects& effects_;
  const PhotonMap* photons_;
  shading::Tracer& tracer_;
  const shading::RayState& ray_;
  const shapes::Surface* end_;
  boost::container::small_vector<const scene::LightSource*, 16> sources_;
  boost::container::small_vector<const shading::Light*, 16> lights_;
};

void see_through(const MediaResult& media, Color& color) {
  const Rgb rgb = color.rgb() * media.transmittance + media.emission;
  color = Color(rgb, 0, color.t * media.transmittance.grey());
}

}  // namespace

// Gather rays that see media look photons up in the surface map (spec 07 2.11).
const PhotonMap* SceneEffects::photons_in_media(const shading::RayState& ray) const {
  return photons ? (ray.gather ? &surface_photons_ : &media_photons_) : nullptr;
}

void SceneEffects::apply(shading::Tracer& tracer, const shading::RayState& ray, double length,
                         const shapes::Surface* end, std::span<const CompiledMedia* const> media, Color& color) const {
  MediaSurroundings environment(*this, photons_in_media(ray), tracer, ray, end);
  see_through(integrate(media, ray.ray, length, false, environment), color);
}

void SceneEffects::container_media(shading::Tracer& tracer, const shading::RayState& ray, double length,
                                   const shapes::Surface& end, Color& color) const {
  MediaList media;
  collect(tracer.interiors(ray.interiors), media);
  if (!media.empty()) apply(tracer, ray, length, &end, {media.data(), media.size()}, color);
}

void SceneEffects::container_media(shading::Tracer& tracer, const shading::RayState& common,
                                   std::span<const shading::MediaSegment> segments) const {
  MediaList media;
  collect(tracer.interiors(common.interiors), media);
  if (!media.empty()) apply(tracer, common, segments, {media.data(), media.size()});
}

void SceneEffects::apply(shading::Tracer& tracer, const shading::RayState& common,
                         std::span<const shading::MediaSegment> segments,
                         std::span<const CompiledMedia* const> media) const {
  MediaSurroundings environment(*this, photons_in_media(common), tracer, common, nullptr);
  MediaBatch batch(tracer, common, media, environment);
  shading::RayState ray = common;
  MediaResult results[MediaBatch::kMaxRays];
  for (std::size_t first = 0; first < segments.size(); first += MediaBatch::kMaxRays) {
    const auto rays = segments.subspan(first, std::min(segments.size() - first, MediaBatch::kMaxRays));
    bool done[MediaBatch::kMaxRays] = {};
    if (batch.possible()) batch.integrate(rays, results, done);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (done[i]) {
        see_through(results[i], *rays[i].color);
        continue;
      }
      tracer.random().begin(rays[i].key);
      ray.ray = rays[i].ray;
      apply(tracer, ray, rays[i].length, rays[i].end, media, *rays[i].color);
    }
  }
}

void SceneEffects::atmosphere_media(shading::Tracer& tracer, const shading::RayState& ray, double length,
                                    const shapes::Surface* end, Color& color) const {
  apply(tracer, ray, length, end, atmosphere_list_, color);
}

void SceneEffects::atmosphere_media(shading::Tracer& tracer, const shading::RayState& common,
                                    std::span<const shading::MediaSegment> segments) const {
  apply(tracer, common, segments, atmosphere_list_);
}

void SceneEffects::shadow_media(shading::Tracer& tracer, const shading::RayState& ray, double length, bool container,
                                bool air, Rgb& color) const {
  MediaSurroundings environment(*this, nullptr, tracer, ray, nullptr);
  if (container) {
    MediaList media;
    collect(tracer.interiors(ray.interiors), media);
    if (!media.empty())
      color *= integrate({media.data(), media.size()}, ray.ray, length, true, environment).transmittance;
  }
  if (air) color *= integrate(atmosphere_list_, ray.ray, length, true, environment).transmittance;
}

}  // namespace verisim::global
