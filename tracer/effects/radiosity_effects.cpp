// Radiosity in the recursive trace: when a layer asks for irradiance, and what a gather ray sees (spec 07
// sections 2.4, 2.6, 2.11).
#include <algorithm>
#include <array>
#include <memory>
#include <numeric>

#include "tracer/effects/effects_state.h"

namespace verisim::global {
namespace {

// Which of 24 parts of the sphere a direction points to; rays that are near each other meet much the same.
int part_of_sphere(const Vec3& d) {
  const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  const int axis = x > y ? (x > z ? 0 : 2) : y > z ? 1 : 2;
  return ((d.x < 0) * 4 + (d.y < 0) * 2 + (d.z < 0)) * 3 + axis;
}

// The rays of a sample, those in the same part of the sphere one after another.
using RayOrder = std::array<std::uint16_t, kGatheredTogether>;
void sort_by_direction(std::span<const FinalGatherRay> rays, RayOrder& order) {
  std::array<std::uint8_t, kGatheredTogether> parts;
  std::array<std::uint16_t, 25> places{};
  for (std::size_t i = 0; i < rays.size(); ++i)
    ++places[1u + (parts[i] = static_cast<std::uint8_t>(part_of_sphere(rays[i].direction)))];
  std::partial_sum(places.begin(), places.end(), places.begin());
  for (std::size_t i = 0; i < rays.size(); ++i) order[places[parts[i]]++] = static_cast<std::uint16_t>(i);
}

class TracerFinalGatherer : public FinalGatherer {
 public:
  TracerFinalGatherer(const SceneEffects& effects, shading::Tracer& tracer) : effects_(effects), tracer_(tracer) {}

  void gather(const Vec3& from, std::span<const FinalGatherRay> rays, int depth, FinalGatherResult* results) override {
    const shading::Tracer::GatherScope scope(tracer_, depth);
    const shading::RandomBranch branch(tracer_.random(), shading::RandomBranch::gather(0));
    const auto key = tracer_.random().key();
    shading::RayState state = gather_state(depth);
    shading::Wavefront* wavefront = rays.size() < kMin ? nullptr : wavefront_of(state);
    RayOrder order;  // decides what rays find that need samples, too, so those that are watched have the same
    if (wavefront)
      sort_by_direction(rays, order);
    else
      std::iota(order.begin(), order.end(), std::uint16_t{0});
    if (tracer_.observed()) wavefront = nullptr;

    constexpr std::size_t kMaxRays = RayBatch::kMax;
    FinalGatherResult* waiting[kMaxRays];
    int n = 0;
    const auto shade_waiting = [&] {
      Color colors[kMaxRays];
      wavefront->shade_gathering(state, colors);
      for (int k = 0; k < n; ++k) waiting[k]->color = colors[k].rgb();
      n = 0;
    };
    for (std::size_t done = 0; done < rays.size(); done += kMaxRays) {
      const auto count = static_cast<int>(std::min(kMaxRays, rays.size() - done));
      RayBatch batch;
      for (int k = 0; k < count; ++k)
        batch.origin.set(k, from), batch.direction.set(k, rays[order[done + k]].direction);
      shapes::Hit hits[kMaxRays];
      bool found[kMaxRays];
      tracer_.scene().world.intersect_batch(batch, 0, count, state.kind(), kNearestHit, nullptr, hits, found);
      for (int k = 0; k < count; ++k) {
        const std::size_t i = order[done + k];
        FinalGatherResult& result = results[i];
        const shapes::Hit* const hit = found[k] ? &hits[k] : nullptr;
        if (hit) result.distance = hit->t;
        result.importance = effects_.importance_of(hit);
        if (result.importance < rays[i].threshold) continue;
        result.shaded = true;
        const auto key_of_ray = shading::RandomSource::branch_key(key, shading::RandomBranch::gather(i));
        if (wavefront) {
          wavefront->add_gathering(batch.at(k), key_of_ray, hit, result.notes);
          waiting[n++] = &result;
          if (wavefront->full()) shade_waiting();
        } else {
          state.ray = batch.at(k);
          state.notes = &result.notes;
          tracer_.random().begin(key_of_ray);
          result.color = tracer_.resolve(state, hit).rgb();
        }
      }
    }
    if (n > 0) shade_waiting();
  }

 private:
  static constexpr double kNearestHit = 1e-4;
  static constexpr std::size_t kMin = 8;  // rays that are worth a wavefront

  shading::RayState gather_state(int depth) const {
    shading::RayState state;
    state.primary = false;
    state.gather = true;
    state.volumes = effects_.scene().settings.radiosity.media;
    state.weight = effects_.radiosity_settings()->gather_weight(depth);
    state.level = RadiositySettings::start_level(depth);
    state.level_limit = std::max(tracer_.scene().max_trace_level, state.level + 1);
    state.gather_depth = depth + 1;
    return state;
  }

  // Null: these rays are shaded one by one.
  shading::Wavefront* wavefront_of(const shading::RayState& state) {
    auto& wavefront = EffectsStateOfScene::of(tracer_).gather_wavefronts[static_cast<std::size_t>(state.gather_depth)];
    if (!wavefront)
      wavefront = std::make_unique<shading::Wavefront>(
          tracer_, state.gather_depth < effects_.scene().settings.radiosity.recursion_limit);
    return wavefront->can_gather() ? wavefront.get() : nullptr;
  }

  const SceneEffects& effects_;
  shading::Tracer& tracer_;
};

}  // namespace

float SceneEffects::importance_of(const shapes::Hit* hit) const {
  const float own = hit ? hit->shape->surface->object->radiosity_importance : -1;
  return own >= 0 ? own : static_cast<float>(scene_.settings.radiosity.default_importance);
}

bool SceneEffects::unimportant(const shapes::Hit* hit, shading::FinalGatherNotes& notes) const {
  notes.importance = importance_of(hit);
  return notes.importance < notes.threshold;
}

Rgb SceneEffects::indirect_light(shading::Tracer& tracer, const shading::RayState& ray, shading::SurfaceHit& at,
                                 const shading::LayerContext& layer) const {
  EffectsStateOfScene& state = EffectsStateOfScene::of(tracer);
  if (!state.radiosity || ray.gather_depth >= scene_.settings.radiosity.recursion_limit) return {};
  const scene::Finish& finish = layer.layer.finish;
  if (finish.subsurface && subsurface && scene_.settings.subsurface_radiosity)
    return {};  // enters through the surface instead
  const Rgb pigment = layer.pigment.rgb();
  const float opacity = rounded_opacity(layer.opacity);
  const float bright = (layer.filter * pigment).grey() * opacity;
  TracerFinalGatherer gatherer(*this, tracer);
  shading::FinalGatherNotes ignored;
  shading::FinalGatherNotes& notes = ray.notes ? *ray.notes : ignored;

  // Asked once per hit, by the first layer that is bright enough; the layers below share the answer.
  const auto side = [&](float coefficient, shading::SurfaceHit::Indirect& memory, double sign) {
    if (coefficient <= 0) return Rgb();
    if (!memory.known && bright * coefficient > tracer.bailout(ray)) {
      memory.known = true;
      const RadiosityQuery query{at.hit.point, at.geometric_normal * sign, layer.normal * sign,
                                 static_cast<double>(ray.weight) * bright * coefficient, ray.gather_depth};
      memory.light = state.radiosity->irradiance(query, gatherer, notes);
    }
    return pigment * memory.light * (opacity * coefficient);
  };
  const Rgb front = side(finish.raw_diffuse, at.indirect, 1.0);
  return front + side(finish.raw_diffuse_back, at.indirect_back, -1.0);
}

bool SceneEffects::raw_irradiance(shading::Tracer& tracer, const shading::RayState& ray, const Vec3& point,
                                  const Vec3& normal, Rgb& light) const {
  EffectsStateOfScene& state = EffectsStateOfScene::of(tracer);
  if (!state.radiosity || ray.gather_depth >= scene_.settings.radiosity.recursion_limit) return false;
  TracerFinalGatherer gatherer(*this, tracer);
  shading::FinalGatherNotes ignored;
  shading::FinalGatherNotes& notes = ray.notes ? *ray.notes : ignored;
  light = state.radiosity->irradiance({point, normal, normal, static_cast<double>(ray.weight), ray.gather_depth},
                                      gatherer, notes);
  return true;
}

}  // namespace verisim::global
