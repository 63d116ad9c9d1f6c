// The walk: from hit to hit, through media, until the path ends.
#include "tracer/path/path_tracer.h"

#include "tracer/film/errors.h"
#include "tracer/math/constants.h"
#include "tracer/path/volume.h"
#include "tracer/shading/atmosphere/fog.h"

namespace verisim::path {
namespace {

constexpr double kMissDistance = 2e10;
constexpr double kLongestMedium = 1e7;  // atmosphere of a ray that hits nothing
constexpr int kRouletteStart = 3;

Vec3 around(const Vec3& axis, double cosine, double phi) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const Vec3 side = std::fabs(axis.x) > 0.5 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  const Vec3 x = normalize(cross(axis, side)), y = cross(axis, x);
  return normalize(axis * cosine + x * (sine * std::cos(phi)) + y * (sine * std::sin(phi)));
}

// A direction to go on in after scattering in a medium, towards which light is followed back.
struct PhaseSample {
  Vec3 direction;
  double density;
};
double phase_density(const scene::Media& media, double cosine) {
  return media.scattering_type == 5 ? normalised_phase(media, cosine) : 1 / (4 * kPi);
}
PhaseSample sample_phase(const scene::Media& media, const Vec3& view, const Vec2& u) {
  const double e = media.scattering_type == 5 ? media.eccentricity : 0;
  double cosine = 1 - 2 * u.x;
  if (std::fabs(e) > 1e-3) {
    const double s = (1 - e * e) / (1 - e + 2 * e * u.x);
    cosine = (1 + e * e - s * s) / (2 * e);
  }
  const Vec3 direction = around(view, std::clamp(cosine, -1.0, 1.0), 2 * kPi * u.y);
  return {direction, phase_density(media, dot(direction, view))};
}

void check_finish(const scene::Finish& finish, bool subsurface) {
  if (finish.subsurface && subsurface)
    throw render::Unsupported("subsurface scattering with --integrator path", finish.place);
  if (finish.reflection.exponent != 1)
    throw render::Unsupported("a reflection exponent with --integrator path: it has no meaning as light transport",
                              finish.place);
}

void check_texture(const scene::Texture& texture, bool subsurface) {
  for (const scene::TextureLayer& layer : texture.layers) check_finish(*layer.finish, subsurface);
  if (texture.texture_map) {
    for (const auto& entry : *texture.texture_map)
      if (entry.value) check_texture(*entry.value, subsurface);
  }
}

void check_object(const scene::Object& object, bool subsurface) {
  if (object.texture) check_texture(*object.texture, subsurface);
  if (object.interior_texture) check_texture(*object.interior_texture, subsurface);
  for (const auto& child : scene::children_of(object)) check_object(*child, subsurface);
}

}  // namespace

void check_supported(const scene::Scene& scene) {
  for (const auto& object : scene.objects) check_object(*object, scene.settings.subsurface);
}

Color PathTracer::radiance(const Ray& ray, Sequence& sequence) {
  const shading::Tracer::InteriorScope scope(tracer_);
  std::vector<const scene::Interior*> start;
  scene_.data.world.interiors_at(ray.origin, start);
  Walk walk;
  walk.ray.ray = ray;
  walk.ray.interiors = tracer_.copied(start);
  walk.ray.hollow = tracer_.all_hollow(walk.ray.interiors);
  ++tracer_.statistics().camera_rays;
  Rgb sum;
  float see_through = 0;
  for (int bounce = 0; bounce < scene_.bounces; ++bounce) {
    if (tracer_.cancel_ && tracer_.cancel_->load(std::memory_order_relaxed)) throw shading::Cancelled();
    if (bounce >= kRouletteStart) {
      const float survival = std::min(0.95f, walk.weight.max_abs());
      if (!(survival > 0) || sequence.next() >= survival) break;
      walk.weight *= 1 / survival;
    }
    shapes::Hit hit;
    const bool found = tracer_.nearest(walk.ray, hit);
    const double length = found ? hit.t : kMissDistance;
    if (walk.seen_directly && walk.ray.hollow) {
      Rgb factor(1), added;
      atmosphere(walk, length, factor, added);
      sum += walk.weight * added;
      walk.weight *= factor;
    }
    if (walk.ray.hollow && !through_media(walk, found ? length : kLongestMedium, sequence, sum)) continue;
    if (walk.weight == Rgb()) break;
    if (!found) {
      const Color sky = scene_.data.sky.seen(walk.ray.ray.direction, walk.ray.reflected || !walk.seen_directly);
      sum += walk.weight * sky.rgb();
      see_through = walk.seen_directly ? sky.t : 0;
      break;
    }
    shading::SurfaceHit at(hit, walk.ray.ray.direction, 0, 0);
    Layers layers;
    Rgb through(1);
    const Rgb emitted = layers_of(walk.ray, at, sequence.next(), layers, through);
    walk.origin.distance += hit.t;
    if (emitted != Rgb()) {
      double share = 1;  // by the balance heuristic against having aimed at it
      if (!walk.origin.direct) {
        const double cosine = std::fabs(dot(at.geometric_normal, walk.ray.ray.direction));
        const double aimed = cosine > 0 ? scene_.emitters.density(at.surface.object) * walk.origin.distance *
                                              walk.origin.distance / cosine
                                        : 0.0;
        share = walk.origin.density / (walk.origin.density + aimed);
      }
      sum += walk.weight * emitted * static_cast<float>(share);
    }
    if (broad_share(layers) > 0) sum += walk.weight * direct_light(walk, at, layers, sequence);
    if (!scatter(walk, at, layers, through, sequence)) break;
  }
  return {sum, 0, see_through};
}

// Fog and rainbows change what is seen, as in POV-Ray; they are no light transport and act where the camera looks.
void PathTracer::atmosphere(const Walk& walk, double length, Rgb& factor, Rgb& added) {
  if (!scene_.data.rainbows.empty()) {
    Rgb keep, bow;
    float count = 0;
    for (const shading::Rainbow& rainbow : scene_.data.rainbows) {
      shading::Rainbow::Effect e;
      if (!rainbow.effect(
              walk.ray.ray.direction, length, [this] { return tracer_.random_.shading(); }, e))
        continue;
      keep += e.keep * e.filter, bow += e.added, count += 1;
    }
    if (count > 0) factor = keep * (1 / count), added = bow * (1 / count);
  }
  if (scene_.data.fog) {
    const shading::FogEffect fog =
        shading::fog_along(scene_.data.scene.fogs, walk.ray.ray, length, scene_.data.scene.settings.noise_generator);
    factor *= fog.passed();
    added = fog.added + fog.passed() * added;
  }
}

bool PathTracer::through_media(Walk& walk, double length, Sequence& sequence, Rgb& sum) {
  global::MediaList media;
  if (length < kLongestMedium)
    scene_.effects.collect(tracer_.interiors(walk.ray.interiors), media);  // containers act on what ends at a surface
  for (const global::CompiledMedia* m : scene_.effects.atmosphere_list()) media.push_back(m);
  if (media.empty()) return true;
  const std::span<const global::CompiledMedia* const> list(media.data(), media.size());
  const VolumeWalk event = delta_track(list, walk.ray.ray, length, sequence, walk.weight, sum);
  if (!event.scattered) return true;

  const scene::Media& medium = *event.medium->description;
  const Vec3 p = walk.ray.ray.at(event.distance), view = walk.ray.ray.direction;
  walk.ray.primary = false, walk.ray.gather = true, walk.ray.continuation = false;
  walk.ray.ray.origin = p;
  // Light sources shine by POV-Ray's rule, S k I (spec 07 4.4).
  for (std::size_t i = 0; i < scene_.data.global_lights(); ++i) {
    const shading::Light& light = scene_.data.lights()[i];
    if (!light.source().media_interaction || light.source().kind == scene::LightKind::shadowless) continue;
    const Vec2 u = sequence.next2();
    const Vec3 offset = light.area() ? light.offset(light.axes(light.direction(p).towards), u.x * (light.size1() - 1),
                                                    u.y * (light.size2() - 1))
                                     : Vec3(0, 0, 0);
    const shading::LightDirection to = light.direction(p, offset);
    const Rgb color =
        light.color() * static_cast<float>(light.attenuation(p, to) * global::phase(medium, dot(to.towards, view)));
    if (color.max_abs() > 0)
      sum += walk.weight * visible(walk.ray, nullptr, light, p, to.towards, to.distance, color, sequence);
  }
  // More light scattered than taken away (extinction below 1) is a trick for a single bounce: further light is not
  // multiplied.
  walk.weight *= static_cast<float>(std::clamp(medium.extinction, 0.0, 1.0));
  if (walk.weight == Rgb()) return true;
  sum += walk.weight * from_emitter(walk.ray, p, sequence, [&](const Vec3& direction, double& continued) {
           const double cosine = dot(direction, view);
           continued = phase_density(medium, cosine);
           return Rgb(static_cast<float>(normalised_phase(medium, cosine)));
         });
  const PhaseSample next = sample_phase(medium, view, sequence.next2());
  walk.weight *= static_cast<float>(normalised_phase(medium, dot(next.direction, view)) / next.density);
  walk.ray.ray.direction = next.direction;
  walk.origin = {false, next.density, 0};
  walk.seen_directly = false;
  return false;
}

// Light from a chosen point of an emitting surface, weighed by the balance heuristic against meeting it by chance.
template <class Scattered>
Rgb PathTracer::from_emitter(const shading::RayState& state, const Vec3& from, Sequence& sequence,
                             Scattered&& scattered) {
  if (scene_.emitters.empty()) return {};
  const double which = sequence.next();
  const Emitters::Point target = scene_.emitters.sample(which, sequence.next2());
  const Vec3 to = target.point - from;
  const double distance = length(to);
  if (!(distance > 1e-6)) return {};
  const Vec3 direction = to / distance;
  double continued = 0;
  Rgb share = scattered(direction, continued);
  if (share == Rgb()) return {};

  // Straight on, through clear surfaces that do not bend it, to the first other surface: it must be the emitter, there.
  const shading::Tracer::InteriorScope scope(tracer_);
  shading::RayState ray = state;
  ray.ray = {from, direction};
  ray.primary = false, ray.gather = true, ray.continuation = false;
  double gone = 0;
  ++tracer_.statistics().shadow_rays;
  for (int surfaces = 0; surfaces < 100; ++surfaces) {
    shapes::Hit hit;
    if (!tracer_.nearest(ray, hit, 1e-4, distance - gone + 1e-4 * (1 + distance))) return {};
    if (ray.hollow) {
      global::MediaList media;
      scene_.effects.collect(tracer_.interiors(ray.interiors), media);
      for (const global::CompiledMedia* m : scene_.effects.atmosphere_list()) media.push_back(m);
      if (!media.empty()) share *= transmittance({media.data(), media.size()}, ray.ray, hit.t, sequence);
    }
    gone += hit.t;
    shading::SurfaceHit at(hit, direction, 0, 0);
    Layers layers;
    Rgb through(1);
    const Rgb emitted = layers_of(ray, at, sequence.next(), layers, through);
    if (hit.shape->surface->object == target.object && std::fabs(gone - distance) < 1e-3 * (1 + distance) * 0.1) {
      const double cosine = std::fabs(dot(at.geometric_normal, direction));
      if (!(cosine > 1e-9)) return {};
      const double aimed = scene_.emitters.density(target.object) * distance * distance / cosine;
      return share * emitted * static_cast<float>(1 / (aimed + continued));
    }
    if (layers.empty() || through == Rgb()) return {};
    const scene::Interior& x = *at.surface.interior;
    const shading::Tracer::Refraction refraction = tracer_.cross_surface(ray, x);
    if (!refraction.straight() || refraction.disperses()) return {};
    share *= through * x.refraction * tracer_.fade_factor(ray.interiors, x, hit.t);
    ray.interiors = refraction.interiors, ray.hollow = refraction.hollow;
    ray.ray.origin = hit.point;
  }
  return {};
}

Rgb PathTracer::emitter(const Walk& walk, shading::SurfaceHit& at, const Layers& layers, Sequence& sequence) {
  return from_emitter(walk.ray, at.hit.point, sequence, [&](const Vec3& direction, double& continued) {
    continued = density(walk.ray.ray.direction, layers, direction);
    return response(walk.ray, at, layers, direction);
  });
}

}  // namespace verisim::path
