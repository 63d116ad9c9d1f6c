// Radiosity in the recursive trace: when a layer asks for irradiance, and what a gather ray sees (spec 07 sections 2.4, 2.6, 2.11).
#include "tracer/global/effects_state.h"

namespace verisim::global {
namespace {

class TracerGatherer : public Gatherer {
 public:
  TracerGatherer(const SceneEffects& effects, shading::Tracer& tracer) : effects_(effects), tracer_(tracer) {}

  GatherResult gather(const Ray& ray, int depth, float threshold) override {
    const scene::Radiosity& settings = effects_.scene().settings.radiosity;
    shading::RayState state;
    state.ray = ray;
    state.primary = false;
    state.gather = true;
    state.volumes = settings.media;
    state.weight = effects_.radiosity_settings()->gather_weight(depth);
    state.level = RadiositySettings::start_level(depth);
    state.level_limit = std::max(tracer_.scene().max_trace_level, state.level + 1);
    state.gather_depth = depth + 1;

    GatherResult result;
    state.gather_quality = &result.quality;
    shapes::Hit hit;
    const bool found = tracer_.nearest(state, hit);
    if (found) {
      result.distance = hit.t;
      result.importance = hit.shape->surface->object->radiosity_importance;
    }
    if (!found || result.importance < 0) result.importance = static_cast<float>(settings.default_importance);
    if (result.importance < threshold) return result;
    result.shaded = true;
    result.color = tracer_.resolve(state, found ? &hit : nullptr).rgb();
    return result;
  }

 private:
  const SceneEffects& effects_;
  shading::Tracer& tracer_;
};

}  // namespace

Rgb SceneEffects::indirect_light(shading::Tracer& tracer, const shading::RayState& ray, shading::SurfaceHit& at,
                                 const shading::LayerContext& layer) const {
  EffectsStateOfScene& state = EffectsStateOfScene::of(tracer);
  if (!state.radiosity || ray.gather_depth >= scene_.settings.radiosity.recursion_limit) return {};
  const scene::Finish& finish = layer.layer.finish;
  if (finish.subsurface && subsurface && scene_.settings.subsurface_radiosity) return {};  // enters through the surface instead
  const Rgb pigment = layer.pigment.rgb();
  const float bright = (layer.filter * pigment).grey() * layer.opacity;
  TracerGatherer gatherer(*this, tracer);
  float ignored = 1;
  float& quality = ray.gather_quality ? *ray.gather_quality : ignored;

  // Asked once per hit, by the first layer that is bright enough; the layers below share the answer.
  const auto side = [&](float coefficient, shading::SurfaceHit::Indirect& memory, double sign) {
    if (coefficient <= 0) return Rgb();
    if (!memory.known && bright * coefficient > tracer.bailout(ray)) {
      memory.known = true;
      const RadiosityQuery query{at.hit.point, at.raw * sign, layer.normal * sign, static_cast<double>(ray.weight) * bright * coefficient,
                                 ray.gather_depth};
      memory.light = state.radiosity->irradiance(query, gatherer, quality);
    }
    return pigment * memory.light * (layer.opacity * coefficient);
  };
  const Rgb front = side(finish.raw_diffuse, at.indirect, 1.0);
  return front + side(finish.raw_diffuse_back, at.indirect_back, -1.0);
}

bool SceneEffects::raw_irradiance(shading::Tracer& tracer, const shading::RayState& ray, const Vec3& point, const Vec3& normal, Rgb& light) const {
  EffectsStateOfScene& state = EffectsStateOfScene::of(tracer);
  if (!state.radiosity || ray.gather_depth >= scene_.settings.radiosity.recursion_limit) return false;
  TracerGatherer gatherer(*this, tracer);
  float ignored = 1;
  float& quality = ray.gather_quality ? *ray.gather_quality : ignored;
  light = state.radiosity->irradiance({point, normal, normal, static_cast<double>(ray.weight), ray.gather_depth}, gatherer, quality);
  return true;
}

}  // namespace verisim::global
