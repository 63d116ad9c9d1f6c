// Subsurface scattering in the recursive trace (spec 07 section 5).
#include <algorithm>

#include "tracer/effects/effects_state.h"
#include "tracer/math/constants.h"
#include "tracer/shading/finish.h"
#include "tracer/shapes/rays_within.h"

namespace verisim::global {
namespace {

// That of the shape, which `inverse` does not turn.
Vec3 outward_normal(const shapes::Hit& hit) {
  const Vec3 n = hit.shape->normal(hit);
  return hit.shape->object->inverted ? -n : n;
}

constexpr std::uint32_t kCycle = 32767;  // of both sequences

// Directions uniform on the sphere, Halton bases 2 and 3 (spec 07 5.2).
const std::vector<Vec3>& sphere_directions() {
  static const std::vector<Vec3> table = [] {
    const auto inverse = [](std::uint32_t k, std::uint32_t base) {
      double result = 0.0, digit = 1.0 / base;
      for (; k > 0; k /= base, digit /= base) result += digit * (k % base);
      return result;
    };
    std::vector<Vec3> t;
    t.reserve(kCycle);
    for (std::uint32_t k = 1; k <= kCycle; ++k) {
      const double x = -1.0 + 2.0 * inverse(k, 2), r = std::sqrt(1.0 - x * x), phi = 2.0 * kPi * inverse(k, 3);
      t.emplace_back(x, r * std::cos(phi), r * std::sin(phi));
    }
    return t;
  }();
  return table;
}

class SubsurfaceSurroundings : public SubsurfaceEnvironment {
 public:
  SubsurfaceSurroundings(const SceneEffects& effects, shading::Tracer& tracer, const shading::RayState& ray,
                         const shading::SurfaceHit& at, EffectsStateOfScene& state)
      : effects_(effects),
        tracer_(tracer),
        ray_(ray),
        at_(at),
        sequence_(state.subsurface[static_cast<std::size_t>(state.subsurface_level)]) {
    const shading::SceneData& scene = tracer.scene();
    if (!at.surface.ignore_global_lights) {
      for (std::size_t i = 0; i < scene.global_lights(); ++i) lights_.push_back(&scene.lights()[i]);
    }
    for (const scene::LightSource* source : at.surface.group_lights()) lights_.push_back(&scene.light_of(source));
  }

  bool nearest(const Ray& ray, SurfaceHit& hit) override {
    const shapes::RaysWithin within;
    shapes::Hit found;
    shading::RayState state = ray_;
    state.ray = ray;
    if (!tracer_.nearest(state, found, std::numeric_limits<double>::min())) return false;
    hit = {found.t, found.point, outward_normal(found), found.shape->surface->interior};
    return true;
  }

  void nearest(const Vec3& origin, std::span<const Vec3> directions, SurfaceHit* hits, bool* found) override {
    const shapes::RaysWithin within;
    RayBatch batch;
    shapes::Hit met[RayBatch::kSize];
    for (std::size_t begin = 0; begin < directions.size(); begin += RayBatch::kMax) {
      const std::size_t size = std::min<std::size_t>(RayBatch::kMax, directions.size() - begin);
      for (std::size_t i = 0; i < RayBatch::kSize; ++i) {
        batch.origin.set(static_cast<int>(i), origin);
        batch.direction.set(static_cast<int>(i), directions[begin + std::min(i, size - 1)]);
      }
      tracer_.scene().world.intersect_batch(batch, 0, static_cast<int>(size), ray_.kind(),
                                            std::numeric_limits<double>::min(), nullptr, met, found + begin);
      for (std::size_t i = 0; i < size; ++i) {
        if (found[begin + i])
          hits[begin + i] = {met[i].t, met[i].point, outward_normal(met[i]), met[i].shape->surface->interior};
      }
    }
  }

  std::size_t lights() override { return lights_.size(); }

  bool illumination(std::size_t light, const Vec3& p, Rgb& color, Vec3& to_light) override {
    shading::RayState state = ray_;
    state.interiors = {};  // light comes as from outside of everything
    color = tracer_.light_at(*lights_[light], p, state, false, to_light);
    return color.max_abs() > 0.0f;
  }

  Vec3 direction_to(std::size_t light, const Vec3& p) override { return lights_[light]->direction(p).towards; }

  Rgb transmitted(const Ray& inner, const SurfaceHit& exit, double share) override {
    // Out through the far side: a refracted child that has left the interior.
    const shading::Tracer::InteriorScope scope(tracer_);
    const auto outside = shading::refracted_direction(inner.direction, exit.normal, at_.surface.interior->ior);
    if (!outside) return {};
    shading::RayState child = ray_.spawn({exit.point, *outside}, at_.level, ray_.weight * static_cast<float>(share));
    child.refracted = true;
    ++tracer_.statistics().refracted_rays;
    return tracer_.trace(child).rgb();
  }

  bool replay() const override { return tracer_.random().replay(); }

  bool irradiance(const Vec3& point, const Vec3& normal, Rgb& light) override {
    if (!tracer_.scene().scene.settings.subsurface_radiosity) return false;
    return effects_.raw_irradiance(tracer_, ray_, point, normal, light);
  }

  Vec3 sphere_direction() override {
    const Vec3& d = sphere_directions()[sequence_.halton];
    sequence_.halton = (sequence_.halton + 1) % kCycle;
    return d;
  }

  double random() override {
    if (replay()) return streamed();
    return tracer_.random().shading();
  }

 private:
  double streamed() {
    // The first value of the stream is element 1 of the generator's table (spec 07 section 1).
    const double v = shading::mersenne_table()[1 + sequence_.stream % kCycle];
    sequence_.stream = (sequence_.stream + 1) % kCycle;
    return v;
  }

  const SceneEffects& effects_;
  shading::Tracer& tracer_;
  const shading::RayState& ray_;
  const shading::SurfaceHit& at_;
  EffectsStateOfScene::SubsurfaceSequence& sequence_;
  boost::container::small_vector<const shading::Light*, 16> lights_;
};

}  // namespace

Rgb SceneEffects::subsurface_light(shading::Tracer& tracer, const shading::RayState& ray, shading::SurfaceHit& at,
                                   const shading::LayerContext& layer) const {
  EffectsStateOfScene& state = EffectsStateOfScene::of(tracer);
  // Gather rays see no direct diffuse light on such a surface unless radiosity { subsurface on } (spec 07 2.11).
  if (ray.gather && !scene_.settings.radiosity.subsurface) return {};
  if (state.subsurface_level >= kMaxSubsurfaceLevel) return {};
  const scene::Finish& finish = layer.layer.finish;
  SubsurfaceSettings settings = subsurface_settings_;
  if (state.subsurface_level > 0) settings.diffuse_samples = settings.single_samples = 1;
  if (!ray.direct_light) {
    // The radiosity pretrace: only what is seen straight through, and where radiosity is asked for below the surface.
    settings.single_samples = 0;
    if (!scene_.settings.subsurface_radiosity) settings.diffuse_samples = 0;
  }
  SubsurfacePoint point;
  point.point = at.hit.point;
  point.normal = at.geometric_normal;  // normal patterns do not turn it (spec 07 5.2)
  point.view = ray.ray.direction;
  point.interior = at.surface.interior;
  point.relative_ior = tracer.fresnel_ratio(ray, *at.surface.interior);
  point.reflectance = layer.pigment.rgb() * finish.raw_diffuse;
  point.translucency = finish.translucency;
  SubsurfaceSurroundings environment(*this, tracer, ray, at, state);
  ++state.subsurface_level;
  const Rgb light = global::subsurface(point, settings, environment);
  --state.subsurface_level;
  return light;
}

}  // namespace verisim::global
