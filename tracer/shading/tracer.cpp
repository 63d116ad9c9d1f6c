#include "tracer/shading/tracer.h"

#include <utility>

#include <boost/container/static_vector.hpp>

#include "tracer/shading/atmosphere/fog.h"

namespace verisim::shading {
namespace {

// Straight continuations do not count as levels, so their number is only limited here, by the stack; POV-Ray itself
// fails at about 300.
constexpr int kMaxNesting = 1000;

struct Nested {
  int& n;
  explicit Nested(int& value) : n(value) { ++n; }
  ~Nested() { --n; }
};

}  // namespace

Tracer::Tracer(const SceneData& scene, const RandomSource& random, const std::atomic<bool>* cancel)
    : scene_(scene),
      random_(random),
      cancel_(cancel),
      in_order_(random.replay() || scene.world.filters_twice()),
      coherent_(scene.world),
      effects_state_(scene.effects ? scene.effects->make_state() : nullptr) {
  lights_in_batches_ = scene.quality >= 4 && !in_order_ && !scene.world.has_transparent_shadows();
  for (std::size_t i = 0; i < scene.global_lights(); ++i) {
    const Light& light = scene.lights()[i];
    lights_in_batches_ =
        lights_in_batches_ && !light.projector() && !((scene.fog || scene.any_media()) && light.media_attenuation());
    area_lights_ = area_lights_ || light.area() || light.area_illumination();
  }
  has_volumes_ = scene.quality >= 9 && scene.air_shows();
}

RayState Tracer::camera_state(const Ray& ray, bool origin_varies) {
  if (origin_varies || !camera_interiors_known_) {
    interiors_.clear();
    if (camera_holders_)
      scene_.world.interiors_at(ray.origin, *camera_holders_, interiors_);
    else
      scene_.world.interiors_at(ray.origin, interiors_);
    camera_interiors_ = interiors_.size();
    camera_interiors_known_ = true;
  }
  RayState state;
  state.ray = ray;
  state.interiors = {0, static_cast<std::uint32_t>(camera_interiors_)};
  state.hollow = lens_is_hollow_ && all_hollow(state.interiors);
  state.level_limit = scene_.max_trace_level;
  // The pretrace asks for samples alone. But how many rays go through a lens hangs on their colours, and where POV-Ray
  // finds isosurfaces on what it looked for before (spec 07 2.9).
  const scene::Camera& camera = scene_.scene.camera;
  const bool blurs = camera.aperture != 0 && camera.blur_samples > 0;
  state.direct_light = state.volumes = !pretrace_ || random_.replay() || blurs;
  coherent_.set_viewpoint(ray.origin);
  return state;
}

Color Tracer::trace_camera(const Ray& ray, bool origin_varies, double t_max, const accel::WorldEntry* entry) {
  RayState state = camera_state(ray, origin_varies);
  FinalGatherNotes notes;
  state.notes = &notes;
  ++statistics_.camera_rays;
  return trace(state, t_max, entry);
}

bool Tracer::cut_off(const RayState& ray) const {
  return ray.level >= ray.level_limit || ray.weight < bailout(ray) || nesting_ >= kMaxNesting;
}

bool Tracer::nearest(const RayState& ray, shapes::Hit& hit, double t_min, double t_max,
                     const accel::WorldEntry* entry) const {
  return scene_.world.intersect(ray.ray, ray.kind(), t_min, t_max, hit, entry);
}

Color Tracer::trace(const RayState& ray, double t_max, const accel::WorldEntry* entry) {
  if (cut_off(ray)) {
    if (observer_) observer_->ray_cut_off(ray);
    return {};
  }
  shapes::Hit hit;
  return resolve(ray, nearest(ray, hit, kNearestHit, t_max, entry) ? &hit : nullptr);
}

Color Tracer::resolve(const RayState& ray, const shapes::Hit* hit) {
  if (cut_off(ray)) return {};
  if (cancel_ && cancel_->load(std::memory_order_relaxed)) throw Cancelled();
  const Nested nested(nesting_);
  if (observer_) observer_->ray_started(ray, hit);
  const Color color = ray.notes ? seen_if_important(ray, hit) : seen_along(ray, hit);
  if (observer_) observer_->ray_ended(ray, color);
  return color;
}

// What it starts in turn asks for nothing, but what starts beside it afterwards does again.
Color Tracer::seen_if_important(const RayState& ray, const shapes::Hit* hit) {
  if (ray.notes->threshold >= 0 && scene_.effects->unimportant(hit, *ray.notes)) return {};
  const float threshold = std::exchange(ray.notes->threshold, -1.0f);
  const Color color = seen_along(ray, hit);
  ray.notes->threshold = threshold;
  return color;
}

Color Tracer::seen_along(const RayState& ray, const shapes::Hit* hit) {
  Color color;
  const double length = hit ? hit->t : kMissDistance;
  if (hit) {
    color = shade(ray, *hit);
  } else {
    color = scene_.sky.seen(ray.ray.direction, ray.reflected || ray.gather);
  }
  if (has_volumes_ && ray.hollow && ray.volumes) {
    through_air(color, [&] { apply_volumes(ray, length, hit ? hit->shape->surface : nullptr, color); });
  }
  return color;
}

Color Tracer::resolve_surface(const RayState& ray, const shapes::Hit& hit) {
  if (cancel_ && cancel_->load(std::memory_order_relaxed)) throw Cancelled();
  const Nested nested(nesting_);
  return shade_surface(ray, hit);
}

// Rainbow, atmosphere, fog: in this order, over the whole segment (spec 06 2.2 step 5).
void Tracer::apply_volumes(const RayState& ray, double length, const shapes::Surface* end, Color& color) {
  const RandomBranch branch(random_, RandomBranch::kAir);
  if (!scene_.rainbows.empty()) {
    Rgb sum;
    float count = 0, see_through = 1;
    for (const Rainbow& rainbow : scene_.rainbows) {
      Rainbow::Effect e;
      if (!rainbow.effect(
              ray.ray.direction, length, [this] { return random_.shading(); }, e))
        continue;
      sum += e.keep * color.rgb() * e.filter + e.added;
      see_through *= e.see_through;
      count += 1;
    }
    if (count > 0) color = Color(sum * (1 / count), 0, color.t * see_through);
  }
  if (scene_.effects && scene_.effects->atmosphere) scene_.effects->atmosphere_media(*this, ray, length, end, color);
  apply_fog({{{ray.ray, length, end, {}, &color}}});
}

void Tracer::apply_fog(std::span<const MediaSegment> segments) const {
  if (!scene_.fog) return;
  boost::container::static_vector<FogSegment, textures::PointBatch::kMax> ways;
  for (const MediaSegment& s : segments) ways.push_back({s.ray, s.length});
  fog_along(scene_.scene.fogs, scene_.scene.settings.noise_generator, std::span(ways.data(), ways.size()));
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const FogEffect& fog = ways[k].effect;
    Color& color = *segments[k].color;
    color = Color(fog.added + fog.passed() * color.rgb(), 0, color.t * fog.passed().grey());
  }
}

InteriorRange Tracer::copied(std::span<const scene::Interior* const> list) {
  const InteriorRange range{static_cast<std::uint32_t>(interiors_.size()), static_cast<std::uint32_t>(list.size())};
  for (std::size_t i = 0; i < list.size(); ++i) interiors_.push_back(list[i]);
  return range;
}

InteriorRange Tracer::crossed(const InteriorRange& from, const scene::Interior* x) {
  // Indices, not pointers: push_back may move the stack.
  const auto begin = static_cast<std::uint32_t>(interiors_.size());
  std::uint32_t skip = from.count;  // position of the entry to leave out
  if (from.count > 0 && interiors_[from.begin + from.count - 1] == x) {
    skip = from.count - 1;
  } else {
    for (std::uint32_t i = 0; i < from.count; ++i) {
      if (interiors_[from.begin + i] == x) {
        skip = i;
        break;
      }
    }
  }
  for (std::uint32_t i = 0; i < from.count; ++i)
    if (i != skip) interiors_.push_back(interiors_[from.begin + i]);
  if (skip == from.count) interiors_.push_back(x);
  return {begin, static_cast<std::uint32_t>(interiors_.size()) - begin};
}

bool Tracer::all_hollow(const InteriorRange& range) const {
  for (const scene::Interior* interior : interiors(range))
    if (!interior->hollow) return false;
  return true;
}

}  // namespace verisim::shading
