// Media in the recursive trace: which media act on a segment, and the light they see (spec 07 sections 4.2, 4.4, 4.7).
#include <boost/container/small_vector.hpp>

#include "tracer/global/effects_state.h"
#include "tracer/shading/shadow_row.h"

namespace verisim::global {

using shading::LightWay;

// What is in the way from some places of rays that go together to the global lights, found for the same place of all of them at once: shadow rays from there
// go side by side. Those from one place of a ray to the next do not.
struct MediaWays {
  static constexpr int kMostRays = shading::ShadowRow::kMost, kMostPlaces = 128;
  std::vector<LightWay> ways;  // of each light, of each place, of each ray
  int places = 0;
  LightWay* row(std::size_t light, int place) { return ways.data() + (light * kMostPlaces + static_cast<std::size_t>(place)) * kMostRays; }
};
struct RayWays {
  MediaWays& all;
  int ray, places;
};

namespace {

constexpr double kPi = 3.14159265358979323846;

class TracerEnvironment : public MediaEnvironment {
 public:
  TracerEnvironment(const SceneEffects& effects, const PhotonMap* photons, shading::Tracer& tracer, const shading::RayState& ray, const shapes::Surface* end, const RayWays* ways = nullptr)
      : effects_(effects), photons_(photons), tracer_(tracer), ray_(ray), end_(end), ways_(ways) {}

  double random() override { return tracer_.random().media(); }
  bool replay() const override { return tracer_.random().replay(); }

  std::span<const scene::LightSource* const> lights() override {
    sources_.clear(), lights_.clear();
    const auto add = [&](const shading::Light& light) {
      if (!light.source().media_interaction || light.source().kind == scene::LightKind::shadowless) return;
      sources_.push_back(&light.source()), lights_.push_back(&light);
    };
    const shading::SceneData& scene = tracer_.scene();
    if (!end_ || !end_->ignore_global_lights) {
      for (std::size_t i = 0; i < scene.global_lights(); ++i) add(scene.lights()[i]);
    }
    if (end_) {
      for (const scene::LightSource* source : end_->group_lights) add(scene.light_of(source));
    }
    return {sources_.data(), sources_.size()};
  }

  Rgb illumination(std::size_t light, const Vec3& p, Vec3& to_light, int place) override { return tracer_.light_at(*lights_[light], p, ray_, to_light, way(light, place)); }

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
  LightWay way(std::size_t light, int place) const {
    if (!ways_ || place < 0 || place >= ways_->places) return LightWay::unknown;
    const auto number = static_cast<std::size_t>(lights_[light] - tracer_.scene().lights().data());
    return number < tracer_.scene().global_lights() ? ways_->all.row(number, place)[ways_->ray] : LightWay::unknown;
  }

  const SceneEffects& effects_;
  const PhotonMap* photons_;
  shading::Tracer& tracer_;
  const shading::RayState& ray_;
  const shapes::Surface* end_;
  const RayWays* ways_;
  boost::container::small_vector<const scene::LightSource*, 16> sources_;
  boost::container::small_vector<const shading::Light*, 16> lights_;
};

}  // namespace

void SceneEffects::apply(shading::Tracer& tracer, const shading::RayState& ray, double length, const shapes::Surface* end,
                         std::span<const CompiledMedia* const> media, Color& color, const RayWays* ways) const {
  // Gather rays that see media look photons up in the surface map (spec 07 2.11).
  const PhotonMap* map = photons ? (ray.gather ? &surface_photons_ : &media_photons_) : nullptr;
  TracerEnvironment environment(*this, map, tracer, ray, end, ways);
  const MediaResult result = integrate(media, ray.ray, length, false, environment);
  const Rgb rgb = color.rgb() * result.transmittance + result.emission;
  color = Color(rgb, 0, color.t * result.transmittance.grey());
}

void SceneEffects::container_media(shading::Tracer& tracer, const shading::RayState& ray, double length, const shapes::Surface& end,
                                   Color& color) const {
  MediaList media;
  collect(tracer.interiors(ray.interiors), media);
  if (!media.empty()) apply(tracer, ray, length, &end, {media.data(), media.size()}, color);
}

void SceneEffects::container_media(shading::Tracer& tracer, const shading::RayState& common, std::span<const shading::ContainerStretch> stretches) const {
  MediaList list;
  collect(tracer.interiors(common.interiors), list);
  if (list.empty()) return;
  const std::span<const CompiledMedia* const> media{list.data(), list.size()};
  shading::RayState ray = common;
  const auto begin = [&](const shading::ContainerStretch& s) {
    ray.ray = s.ray;
    tracer.random().begin(s.key);
  };
  // Where they will look at lights.
  thread_local MediaWays ways;
  thread_local std::array<double, MediaWays::kMostPlaces> places[MediaWays::kMostRays];
  int count[MediaWays::kMostRays], most = 0;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const shading::ContainerStretch& s = stretches[i];
    begin(s);
    TracerEnvironment environment(*this, nullptr, tracer, ray, s.end);
    count[i] = foreseen_places(media, s.ray, s.length, environment, MediaWays::kMostPlaces, places[i].data());
    most = std::max(most, count[i]);
  }
  const shading::SceneData& scene = tracer.scene();
  if (most > 0) ways.ways.resize(scene.global_lights() * MediaWays::kMostPlaces * MediaWays::kMostRays);
  for (int place = 0; place < most; ++place) {
    Vec3 points[MediaWays::kMostRays];
    std::size_t rays[MediaWays::kMostRays], n = 0;
    for (std::size_t i = 0; i < stretches.size(); ++i)
      if (place < count[i] && places[i][place] >= 0) points[n] = stretches[i].ray.at(places[i][place]), rays[n++] = i;
    for (std::size_t light = 0; light < scene.global_lights(); ++light) {
      shading::LightWays found;
      if (scene.lights()[light].source().media_interaction) tracer.look_for_light(scene.lights()[light], common, std::span(points, n), found.data());
      else found.fill(LightWay::unknown);
      LightWay* const row = ways.row(light, place);
      std::fill_n(row, stretches.size(), LightWay::unknown);
      for (std::size_t k = 0; k < n; ++k) row[rays[k]] = found[k];
    }
  }
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    begin(stretches[i]);
    const RayWays own{ways, static_cast<int>(i), count[i]};
    apply(tracer, ray, stretches[i].length, stretches[i].end, media, *stretches[i].color, &own);
  }
}

void SceneEffects::atmosphere_media(shading::Tracer& tracer, const shading::RayState& ray, double length, const shapes::Surface* end,
                                    Color& color) const {
  apply(tracer, ray, length, end, atmosphere_list_, color);
}

void SceneEffects::shadow_media(shading::Tracer& tracer, const shading::RayState& ray, double length, bool container, bool air, Rgb& color) const {
  TracerEnvironment environment(*this, nullptr, tracer, ray, nullptr);
  if (container) {
    MediaList media;
    collect(tracer.interiors(ray.interiors), media);
    if (!media.empty()) color *= integrate({media.data(), media.size()}, ray.ray, length, true, environment).transmittance;
  }
  if (air) color *= integrate(atmosphere_list_, ray.ray, length, true, environment).transmittance;
}

}  // namespace verisim::global
