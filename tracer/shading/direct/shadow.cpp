// How much of a light arrives: occlusion, filters of transparent surfaces, fading and volumes along a shadow ray (spec
// 06 section 9).
#include "tracer/shading/finish.h"
#include "tracer/shading/atmosphere/fog.h"
#include "tracer/shading/tracer.h"
#include "tracer/shapes/implicit/last_miss.h"
#include "tracer/bvh/boxes_along.h"
#include "tracer/bvh/slab_test.h"
#include "tracer/textures/evaluation/pigment.h"

namespace verisim::shading {
namespace {

// Surfaces may reach beyond their box, as those of a disc that cuts do, or of a copy with bounds; and rounding moves
// boxes that are far away behind the light.
bool box_passes(const shapes::Shape& shape, const Ray& ray, double distance) {
  const scene::Object& o = *shape.object;
  if (o.as<scene::Sphere>() || o.as<scene::Box>() || o.as<scene::Plane>() || o.as<scene::Triangle>() ||
      o.as<scene::SmoothTriangle>() || o.as<scene::Poly>())
    return true;
  return accel::slab_test(o.bounds).passes(ray, static_cast<float>(distance));
}

// What is tested before all others: what surfaces of this level remember, or, where the camera's rays remember nothing
// yet, what deeper ones do. `last` is in the pair of both.
const shapes::Shape* tested_first(const shapes::Shape* const* last, int surface_level) {
  if (!last || *last || surface_level > 1) return last ? *last : nullptr;
  return last[1];
}

}  // namespace

Rgb Tracer::shadowed(const Light& light, const Vec3& p, const LightDirection& centre, const RayState& ray,
                     const shapes::Surface* lit, Rgb color) {
  if (scene_.quality < 4 || !light.shadows()) return color;
  const ShadowQuery query{ray, lit, light};
  // Radiosity's gather rays see area lights as points (spec 07 2.11).
  if (light.area() && !ray.gather) return area_shadow(query, p, centre, color);
  cast_shadow(query, {{p, centre.towards}, centre.distance}, color);
  return color;
}

const shapes::Shape** Tracer::last_blocker(const ShadowQuery& query) {
  const auto light = static_cast<std::size_t>(&query.light - scene_.lights().data());
  if (!in_order_ || light >= scene_.global_lights()) return nullptr;
  if (last_blockers_.empty()) last_blockers_.resize(scene_.global_lights());
  return &last_blockers_[light][query.eye.surface_level() > 1];
}

void Tracer::begin_block() {
  if (!random_.replay()) {
    last_blockers_.clear(), memory_of_others_.last_blockers.clear();
    shapes::last_miss() = {}, memory_of_others_.last_miss = {};
  }
  shapes::last_miss().kept = in_order_;
}

bool Tracer::filter_by_remembered(const ShadowQuery& query, const shapes::Shape& remembered, double distance,
                                  RayState& ray, Rgb& color) {
  shapes::Hit hit;
  if (!box_passes(remembered, ray.ray, distance) ||
      !remembered.intersect(ray.ray, shapes::RayKind::shadow, kContactTolerance, distance, hit))
    return false;
  if (hit.shape->surface->object->no_shadow) return false;  // casts one in the search only
  if (filter_through(query, ray, hit, color)) return true;
  shadow_volumes(query, ray, hit.t, true, color);
  // The ray has entered the object, and the search, which meets the same surface, has it leave.
  ray.interiors = crossed(ray.interiors, hit.shape->surface->interior);
  ray.hollow = all_hollow(ray.interiors);
  return false;
}

accel::WorldEntry* Tracer::shadow_entry(const ShadowQuery& query, const Vec3& p) {
  const auto light = static_cast<std::uint32_t>(&query.light - scene_.lights().data());
  if (query.light.parallel())
    return coherent_.parallel_shadow(p, light, query.light.direction(p).towards, viewer(query));
  return query.light.box().isEmpty() ? nullptr : coherent_.shadow(p, light, query.light.box(), viewer(query));
}

accel::CoherentRays::Viewer Tracer::viewer(const ShadowQuery& query) {
  return query.lit && query.eye.level == 0 && query.eye.primary ? accel::CoherentRays::Viewer::camera
                                                                : accel::CoherentRays::Viewer::other;
}

bool Tracer::light_on_way_changes(const Light& light, const RayState& eye) const {
  return scene_.quality >= 9 && eye.volumes && light.media_attenuation() && (scene_.fog || scene_.any_media());
}

bool Tracer::any_object_decides(const accel::WorldEntry* entry, const Ray& ray, double length) const {
  return only_opaque(entry) || scene_.world.only_opaque_between(ray.origin, ray.origin + length * ray.direction);
}

void Tracer::cast_shadow(const ShadowQuery& query, ShadowSegment segment, Rgb& color, ShadowSegment* rest) {
  ++statistics_.shadow_rays;
  const Ray ray = segment.ray;
  if (const shapes::Shape* projector = query.light.projector()) {
    shapes::Hit hit;
    if (!projector->intersect(ray, shapes::RayKind::shadow, kProjectorTolerance, segment.length, hit)) {
      color = {};
      return;
    }
    if (!query.light.highlights()) {  // shadowless: the projector and the air are all it heeds
      RayState eye = query.eye;
      eye.ray = ray;
      if (rest)
        *rest = segment;
      else if (segment.length > kShadowTolerance)
        shadow_volumes(query, eye, segment.length, false, color);
      return;
    }
    segment.beyond = segment.length - hit.t;
    segment.length = hit.t;
  }
  // Without transparent objects any opaque hit decides. With them surfaces are met in order: one closer than the
  // tolerance to the transparent surface before it does not count, opaque or not, and media draw their random numbers
  // where POV-Ray's do; what is remembered hangs on all of it.
  accel::WorldEntry* const entry = shadow_entry(query, ray.origin);
  if (light_on_way_changes(query.light, query.eye) || in_order_ || !any_object_decides(entry, ray, segment.length)) {
    filter_along(query, segment, entry, color, rest);
  } else if (segment.length > 2 * kShadowTolerance &&
             scene_.world.occluded(ray, contact_tolerance(query.light), segment.length - kShadowTolerance, entry)) {
    color = {};
  }
}

void Tracer::filter_along(const ShadowQuery& query, ShadowSegment segment, const accel::WorldEntry* entry, Rgb& color,
                          ShadowSegment* rest) {
  const InteriorScope scope(*this);
  const shapes::ShadowRays shadow_rays;
  const shapes::Shape** const last = last_blocker(query);
  RayState ray = query.eye;
  ray.ray = segment.ray;
  double distance = segment.length;
  const shapes::Shape* const remembered = tested_first(last, query.eye.surface_level());
  const auto leave = [&] {
    if (rest) *rest = {ray.ray, distance + segment.beyond};
  };
  // As far as the light; to what it is projected through, less the tolerance of the search (spec 08 D).
  const double reach = query.light.projector() ? distance - kShadowTolerance : distance;
  if (remembered && filter_by_remembered(query, *remembered, reach, ray, color)) {
    color = {};
    leave();
    return;
  }
  double from = in_order_ ? kAboveShadowTolerance : contact_tolerance(query.light);
  // What lies on the way is found once: at the first transparent surface, which is where the ray starts if that is one.
  accel::BoxesAlong boxes;
  double travelled = 0;  // since then
  bool searched = false, known = false;
  const auto find_boxes = [&] {
    searched = true;
    known = scene_.world.boxes_along(ray.ray, from, distance - kShadowTolerance, entry, boxes);
  };
  if (query.lit && !query.lit->opaque) find_boxes();
  const auto look = [&](shapes::Hit& hit) {
    const double limit = distance - kShadowTolerance;
    const auto kind = shapes::RayKind::shadow;
    return known ? scene_.world.intersect_along(ray.ray, kind, from, limit, hit, entry, boxes, travelled)
                 : scene_.world.intersect(ray.ray, kind, from, limit, hit, entry);
  };
  for (bool clear = true;; clear = false) {
    if (cancel_ && cancel_->load(std::memory_order_relaxed)) throw Cancelled();
    shapes::Hit hit;
    if (distance <= 2 * kShadowTolerance || !look(hit)) break;
    from = kAboveShadowTolerance;
    const shapes::Surface& surface = *hit.shape->surface;
    if (hit.t < kAboveShadowTolerance && !surface.opaque) continue;
    if (filter_through(query, ray, hit, color)) {
      if (last && clear && surface.remembered) *last = surface.remembered;
      leave();
      return;
    }
    shadow_volumes(query, ray, hit.t, true, color);
    ray.interiors = crossed(ray.interiors, surface.interior);
    ray.hollow = all_hollow(ray.interiors);
    ray.ray.origin = hit.point;
    distance -= hit.t;
    if (searched)
      travelled += hit.t;
    else
      find_boxes();
  }
  leave();
  distance += segment.beyond;
  if (!rest && distance > kShadowTolerance) shadow_volumes(query, ray, distance, false, color);
}

// Atmosphere and fog act only for lights that ask for it; media of containers always, over segments that end at a
// surface. What is not hollow keeps out everything but the atmosphere before a surface (spec 06 9.4, 07 4.7).
void Tracer::shadow_volumes(const ShadowQuery& query, const RayState& ray, double length, bool to_surface, Rgb& color) {
  if (scene_.quality < 9 || !query.eye.volumes || !(ray.hollow || to_surface)) return;
  const bool attenuates = query.light.media_attenuation();
  if (const Effects* effects = scene_.effects) {
    const bool inside = to_surface && ray.hollow && effects->media_in_interiors && ray.interiors.count > 0,
               air = attenuates && effects->atmosphere;
    if (inside || air) effects->shadow_media(*this, ray, length, inside, air, color);
  }
  if (attenuates && scene_.fog && ray.hollow)
    color *= fog_along(scene_.scene.fogs, ray.ray, length, scene_.scene.settings.noise_generator).passed();
}

// What passes a surface of plain colours alone, which hang neither on the place nor on the side: nothing need be known
// of the hit. False: it is another one.
static bool plain_filter(const shapes::Surface& surface, Rgb& filter) {
  if (surface.shows_several() || surface.interior_texture || surface.interior->caustics != 0) return false;
  const textures::CompiledTexture& texture = *surface.texture;
  if (texture.patterned() || texture.opaque) return false;
  filter = Rgb(1);
  for (const textures::CompiledLayer& layer : texture.layers) {
    if (layer.pigment->source != textures::CompiledPigment::Source::plain) return false;
    filter *= layer.pigment->color.transmission();
  }
  return true;
}

// Multiplies by the filter of one surface; true when nothing passes.
bool Tracer::filter_through(const ShadowQuery& query, const RayState& ray, const shapes::Hit& hit, Rgb& color) {
  const shapes::Surface& surface = *hit.shape->surface;
  if (surface.opaque) {
    color = {};
    return true;
  }
  if (scene_.effects && scene_.effects->photons && scene_.effects->photons_block(query.lit, surface, query.light)) {
    color = {};
    return true;
  }
  Rgb filter;
  if (!plain_filter(surface, filter)) filter = filter_at(hit, ray.ray.direction);
  if (surface.interior->fade_power > 0) filter *= fade_factor(ray.interiors, *surface.interior, hit.t);
  color *= filter;
  return color.max_abs() < kDark;
}

Rgb Tracer::filter_at(const shapes::Hit& hit, const Vec3& towards) {
  const shapes::Surface& surface = *hit.shape->surface;
  SurfaceHit at(hit, towards, 0, 0);
  const Vec3 p = at.pattern_point();
  scene_.world.weighted_textures(hit, at.inside_hit, weighted_);
  if (weighted_.empty()) {
    const auto* texture = surface.texture_within(at.inside_hit);
    return texture ? texture_filter(at, *texture, p, towards, nullptr) : Rgb();
  }
  const std::size_t first = selection_.size();
  selection_.insert(selection_.end(), weighted_.begin(), weighted_.end());
  const std::size_t end = selection_.size();
  Rgb filter;
  for (std::size_t i = first; i < end; ++i) {
    const textures::WeightedTexture entry = selection_[i];
    if (entry.weight >= scene_.adc_bailout)
      filter += scaled(texture_filter(at, *entry.texture, p, towards, nullptr), entry.weight);
  }
  selection_.resize(first);
  return filter;
}

Rgb Tracer::texture_filter(SurfaceHit& at, const textures::CompiledTexture& texture, const Vec3& p, const Vec3& towards,
                           TextureFrames* frames) {
  if (texture.solid) return {};
  if (texture.patterned()) {
    const TextureParts parts(selection_, texture, p, at.texture_point, frames);
    Rgb sum;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (const textures::WeightedTexture entry = parts[i]; entry.weight != 0 || texture.average)
        sum += scaled(texture_filter(at, *entry.texture, parts.point, towards, &parts.frames), entry.weight);
    return sum;
  }
  const float caustics = at.surface.interior->caustics;
  Rgb filter(1);
  for (const textures::CompiledLayer& layer : texture.layers) {
    Color c;
    // Fake caustics: once per layer, so a surface may brighten the light.
    Vec3 normal = at.geometric_normal;
    if (caustics != 0) normal = layer_normal(at, layer, p, frames);
    if (textures::evaluate(*layer.pigment, p, &at.texture_point, c)) filter *= c.transmission();
    if (caustics != 0)
      filter *= static_cast<float>(1 + std::pow(std::fabs(dot(normal, towards)), static_cast<double>(caustics)));
  }
  return filter;
}

}  // namespace verisim::shading
