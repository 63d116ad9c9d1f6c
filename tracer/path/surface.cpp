// Surfaces on a path: what a POV-Ray finish means as a scattering function (docs/path-tracing.md), light sources, and
// how the path goes on.
#include "tracer/math/constants.h"
#include "tracer/path/path_tracer.h"
#include "tracer/path/volume.h"
#include "tracer/shading/dispersion.h"
#include "tracer/shading/finish.h"

namespace verisim::path {
namespace {

// Cosine-power lobe about an axis: density (e + 1) / 2 pi cos^e.
Vec3 power_lobe(const Vec3& axis, double exponent, const Vec2& u) {
  const double cosine = std::pow(1 - u.x, 1 / (exponent + 1)), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)),
               phi = 2 * kPi * u.y;
  const Vec3 side = std::fabs(axis.x) > 0.5 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  const Vec3 x = normalize(cross(axis, side)), y = cross(axis, x);
  return normalize(axis * cosine + x * (sine * std::cos(phi)) + y * (sine * std::sin(phi)));
}
double power_density(double cosine, double exponent) {
  return cosine > 0 ? (exponent + 1) / (2 * kPi) * std::pow(cosine, exponent) : 0.0;
}

}  // namespace

Rgb PathTracer::layers_of(const shading::RayState& ray, shading::SurfaceHit& at, double choice, Layers& layers,
                          Rgb& through) {
  const Vec3 p = at.pattern_point();
  Rgb emitted;
  scene_.data.world.weighted_textures(at.hit, at.inside_hit, tracer_.weighted_);
  const textures::CompiledTexture* texture = at.surface.texture_within(at.inside_hit);
  if (!tracer_.weighted_.empty()) {  // one of them, as often as it weighs
    double total = 0;
    for (const auto& entry : tracer_.weighted_) total += entry.weight;
    double left = choice * total;
    for (const auto& entry : tracer_.weighted_) {
      texture = entry.texture;
      if (left < entry.weight) {
        choice = left / entry.weight;
        break;
      }
      left -= entry.weight;
    }
  }
  if (texture) gather_layers(ray, at, *texture, p, nullptr, choice, layers, emitted, through);
  return emitted;
}

void PathTracer::gather_layers(const shading::RayState& ray, shading::SurfaceHit& at,
                               const textures::CompiledTexture& texture, const Vec3& p, shading::TextureFrames* frames,
                               double choice, Layers& layers, Rgb& emitted, Rgb& through) {
  if (texture.patterned()) {
    const shading::TextureParts parts(tracer_.selection_, texture, p, at.texture_point, frames);
    double total = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) total += parts[i].weight;
    double left = choice * total;
    textures::WeightedTexture one{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].weight <= 0) continue;
      one = parts[i];
      if (left < one.weight) break;
      left -= one.weight;
    }
    if (!one.texture) return;
    gather_layers(ray, at, *one.texture, parts.point, &parts.frames, std::clamp(left / one.weight, 0.0, 1.0), layers,
                  emitted, through);
    return;
  }
  const shading::SceneData& data = scene_.data;
  const Vec3& d = ray.ray.direction;
  through = Rgb(1);
  for (const textures::CompiledLayer& layer : texture.layers) {
    if (through == Rgb()) break;
    const scene::Finish& finish = layer.finish;
    Layer l{&layer, Color(), tracer_.layer_normal(at, layer, p, frames), through, 1, Rgb()};
    const bool colored = textures::evaluate(*layer.pigment, p, &at.texture_point, l.pigment);
    l.opacity = rounded_opacity(shading::surface_opacity(l.pigment, data.version));
    if (finish.reflection.maximum != Rgb() || finish.reflection.minimum != Rgb()) {
      const double eta = finish.reflection.fresnel ? tracer_.fresnel_ratio(ray, *at.surface.interior) : 1.0;
      l.reflectivity = shading::mirror_of(finish.reflection, l.pigment.rgb(), -dot(d, l.normal), eta).reflectivity;
    }
    // The ambient term stands for interreflection and would count it twice; scenes before 3.7 use it for light sources
    // as well (spec 07 2.4).
    const Rgb ambient = data.version < 370 ? finish.ambient * data.scene.settings.ambient_light : Rgb();
    emitted += l.filter * l.pigment.rgb() * (ambient + finish.emission) * l.opacity;
    const double pigment = (l.filter * l.pigment.rgb()).max_abs() * std::fabs(l.opacity), filter = l.filter.max_abs();
    l.share[0] = pigment * std::max(0.0f, finish.diffuse) * 2 / (finish.brilliance + 1.0);
    l.share[1] = pigment * std::max(0.0f, finish.diffuse_back) * 2 / (finish.brilliance + 1.0);
    l.share[2] = filter * std::max(0.0f, finish.phong) * 2 / (shading::phong_highlight(finish).exponent + 1);
    l.share[3] = filter * std::max(0.0f, finish.specular) * 4 / (shading::blinn_highlight(finish).exponent + 1);
    layers.push_back(l);
    if (colored) {
      through *= l.pigment.transmission();
      if (finish.conserve_energy)
        through *= {std::min(1.0f, 1 - l.reflectivity.r), std::min(1.0f, 1 - l.reflectivity.g),
                    std::min(1.0f, 1 - l.reflectivity.b)};
    }
  }
}

double PathTracer::broad_share(const Layers& layers) {
  double sum = 0;
  for (const Layer& l : layers) sum += l.share[0] + l.share[1] + l.share[2] + l.share[3];
  return sum;
}

Rgb PathTracer::direct_light(const Walk& walk, shading::SurfaceHit& at, const Layers& layers, Sequence& sequence) {
  Rgb sum;
  if (!at.surface.ignore_global_lights) {
    for (std::size_t i = 0; i < scene_.data.global_lights(); ++i)
      sum += light_source(walk, at, layers, scene_.data.lights()[i], sequence);
  }
  for (const scene::LightSource* source : at.surface.group_lights())
    sum += light_source(walk, at, layers, scene_.data.light_of(source), sequence);
  return sum + emitter(walk, at, layers, sequence);
}

// A light source shines as POV-Ray's does; an area light from a point chosen on its area.
Rgb PathTracer::light_source(const Walk& walk, shading::SurfaceHit& at, const Layers& layers,
                             const shading::Light& light, Sequence& sequence) {
  const Vec3& p = at.hit.point;
  Vec3 offset(0, 0, 0);
  if (light.area()) {
    const Vec2 u = sequence.next2();
    offset = light.offset(light.axes(light.direction(p).towards), u.x * (light.size1() - 1), u.y * (light.size2() - 1));
  }
  const shading::LightDirection to = light.direction(p, offset);
  const Rgb color = light.color() * static_cast<float>(light.attenuation(p, to));
  if (color == Rgb()) return {};
  Rgb reflected;
  for (const Layer& l : layers) {
    const scene::Finish& finish = l.layer->finish;
    bool back = false;
    if (!at.surface.double_illuminate && dot(l.normal, to.towards) < kEpsilon) {
      if (finish.diffuse_back == 0) continue;
      back = true;
    }
    const shading::LayerContext context{*l.layer, l.pigment, l.normal, l.opacity, l.filter};
    reflected +=
        l.filter * tracer_.layer_response(at, context, walk.ray.ray.direction, to.towards, Rgb(1),
                                          back ? finish.diffuse_back : finish.diffuse, light.highlights() && !back);
  }
  if (reflected == Rgb()) return {};
  return reflected * visible(walk.ray, &at.surface, light, p, to.towards, to.distance, color, sequence);
}

Rgb PathTracer::visible(const shading::RayState& eye, const shapes::Surface* lit, const shading::Light& light,
                        const Vec3& p, const Vec3& towards, double distance, Rgb color, Sequence& sequence) {
  constexpr double kTolerance = 1e-3;  // of shadow rays (spec 06 9.2)
  if (scene_.data.quality < 4 || !light.shadows()) return color;
  ++tracer_.statistics().shadow_rays;
  if (const shapes::Shape* projector = light.projector()) {
    shapes::Hit hit;
    if (!projector->intersect({p, towards}, shapes::RayKind::shadow, kTolerance, distance, hit)) return {};
    if (!light.highlights()) return color;
    distance = hit.t;
  }
  const shading::Tracer::InteriorScope scope(tracer_);
  const shading::Tracer::ShadowQuery query{eye, lit, light};
  shading::RayState ray = eye;
  ray.ray = {p, towards};
  const auto media = [&](double length, bool container) {
    if (!ray.hollow) return;
    global::MediaList list;
    if (container) scene_.effects.collect(tracer_.interiors(ray.interiors), list);
    if (light.media_attenuation())
      for (const global::CompiledMedia* m : scene_.effects.atmosphere_list()) list.push_back(m);
    if (!list.empty()) color *= transmittance({list.data(), list.size()}, ray.ray, length, sequence);
  };
  while (distance > 2 * kTolerance) {
    shapes::Hit hit;
    if (!scene_.data.world.intersect(ray.ray, shapes::RayKind::shadow, std::nextafter(kTolerance, 1.0),
                                     distance - kTolerance, hit))
      break;
    if (tracer_.filter_through(query, ray, hit, color)) return {};
    media(hit.t, true);
    ray.interiors = tracer_.crossed(ray.interiors, hit.shape->surface->interior);
    ray.hollow = tracer_.all_hollow(ray.interiors);
    ray.ray.origin = hit.point;
    distance -= hit.t;
  }
  if (distance > kTolerance) media(distance, false);
  return color;
}

// A light source of intensity I gives diffuse * I * cosine, so it is an irradiance of pi I, and everything else is over
// pi.
Rgb PathTracer::response(const shading::RayState& ray, const shading::SurfaceHit& at, const Layers& layers,
                         const Vec3& direction) {
  const Vec3& view = ray.ray.direction;
  const bool outside = dot(direction, at.geometric_normal) > 0;
  Rgb sum;
  for (const Layer& l : layers) {
    const scene::Finish& finish = l.layer->finish;
    const double cosine = dot(l.normal, direction);
    const bool front = cosine > 0;
    if (front != outside) continue;  // a perturbed normal must not look through the surface
    Rgb own;
    const float k = front ? finish.diffuse : finish.diffuse_back;
    if (k > 0)
      own += l.pigment.rgb() * static_cast<float>(l.opacity * k * shading::brilliance(finish.brilliance, cosine));
    if (front && shading::has_highlight(finish)) {
      Rgb color(static_cast<float>(shading::highlight_strength(finish, l.normal, view, direction)));
      if (finish.metallic > 0) color *= shading::metallic_tint(l.pigment.rgb(), finish.metallic, cosine);
      own += color;
    }
    if (finish.irid > 0)
      own *= tracer_.film_tint(finish, tracer_.film_thickness(finish, at.hit.point),
                               std::fabs(cosine) + std::fabs(dot(l.normal, view)));
    sum += l.filter * own;
  }
  return sum * static_cast<float>(1 / kPi);
}

double PathTracer::density(const Vec3& view, const Layers& layers, const Vec3& direction) {
  double sum = 0, total = 0;
  for (const Layer& l : layers) {
    const scene::Finish& finish = l.layer->finish;
    const double cosine = dot(l.normal, direction);
    if (l.share[0] > 0) sum += l.share[0] * power_density(cosine, finish.brilliance);
    if (l.share[1] > 0) sum += l.share[1] * power_density(-cosine, finish.brilliance);
    if (l.share[2] > 0)
      sum += l.share[2] *
             power_density(shading::phong_cosine(l.normal, view, direction), shading::phong_highlight(finish).exponent);
    if (l.share[3] > 0) {
      const Vec3 h = direction - view;
      const double size = length(h), toward = -dot(view, h) / size;
      if (size > 0 && toward > 0)
        sum += l.share[3] * power_density(dot(h, l.normal) / size, shading::blinn_highlight(finish).exponent) /
               (4 * toward);
    }
    for (const double s : l.share) total += s;
  }
  return total > 0 ? sum / total : 0.0;
}

bool PathTracer::scatter(Walk& walk, shading::SurfaceHit& at, const Layers& layers, const Rgb& through,
                         Sequence& sequence) {
  if (layers.empty()) return false;
  const double broad = broad_share(layers), clear = through.max_abs();
  double mirrors = 0;
  for (const Layer& l : layers) mirrors += l.reflectivity.max_abs();
  const double total = broad + clear + mirrors;
  if (!(total > 0) || !std::isfinite(total)) return false;
  double left = sequence.next() * total;
  if (left < clear) {
    walk.weight *= through * static_cast<float>(total / clear);
    return pass_through(walk, at, layers.front(), sequence);
  }
  left -= clear;
  if (left < mirrors) {
    const Layer* chosen = nullptr;
    for (const Layer& l : layers) {
      const double share = l.reflectivity.max_abs();
      if (share <= 0) continue;
      chosen = &l;
      if (left < share) break;
      left -= share;
    }
    if (!chosen) return false;
    walk.weight *= chosen->reflectivity * static_cast<float>(total / chosen->reflectivity.max_abs());
    mirror(walk, at, *chosen);
    return true;
  }
  left -= mirrors;
  const Vec3 view = walk.ray.ray.direction;
  const Vec2 u = sequence.next2();
  Vec3 direction;
  bool chosen = false;
  for (const Layer& l : layers) {
    const scene::Finish& finish = l.layer->finish;
    for (std::size_t lobe = 0; lobe < l.share.size() && !chosen; ++lobe) {
      if (l.share[lobe] <= 0) continue;
      // The last lobe is taken if rounding leaves a rest.
      if (left >= l.share[lobe] && !(&l == &layers.back() && lobe == 3)) {
        left -= l.share[lobe];
        continue;
      }
      chosen = true;
      if (lobe == 0) direction = power_lobe(l.normal, finish.brilliance, u);
      if (lobe == 1) direction = power_lobe(-l.normal, finish.brilliance, u);
      if (lobe == 2)
        direction = power_lobe(shading::mirrored(view, l.normal), shading::phong_highlight(finish).exponent, u);
      if (lobe == 3)
        direction = shading::mirrored(view, power_lobe(l.normal, shading::blinn_highlight(finish).exponent, u));
    }
    if (chosen) break;
  }
  if (!chosen) return false;
  const double chance = density(view, layers, direction);
  if (!(chance > 0)) return false;
  walk.weight *= response(walk.ray, at, layers, direction) * static_cast<float>(total / broad / chance);
  if (walk.weight == Rgb()) return false;
  walk.ray.ray = {at.hit.point, direction};
  if (dot(direction, at.geometric_normal) <
      0) {  // scattered to the other side: the ray is then inside, as one that passes
    const shading::Tracer::Refraction refraction = tracer_.cross_surface(walk.ray, *at.surface.interior);
    walk.ray.interiors = refraction.interiors, walk.ray.hollow = refraction.hollow;
  }
  walk.ray.primary = false, walk.ray.reflected = false, walk.ray.gather = true, walk.ray.continuation = false;
  walk.origin = {false, chance, 0};
  walk.seen_directly = false;
  return true;
}

void PathTracer::mirror(Walk& walk, const shading::SurfaceHit& at, const Layer& layer) {
  const Vec3 d = walk.ray.ray.direction;
  walk.ray.ray = {at.hit.point, shading::reflected_direction(d, layer.normal, at.geometric_normal)};
  if (const scene::Finish& finish = layer.layer->finish; finish.irid > 0)
    walk.weight *=
        tracer_.film_tint(finish, tracer_.film_thickness(finish, at.hit.point),
                          std::fabs(dot(layer.normal, walk.ray.ray.direction)) + std::fabs(dot(layer.normal, d)));
  walk.ray.primary = false, walk.ray.reflected = true, walk.ray.continuation = false;
  walk.origin = {};
  ++tracer_.statistics().reflected_rays;
}

bool PathTracer::pass_through(Walk& walk, shading::SurfaceHit& at, const Layer& top, Sequence& sequence) {
  const scene::Interior& x = *at.surface.interior;
  const shading::Tracer::Refraction refraction = tracer_.cross_surface(walk.ray, x);
  walk.weight *= tracer_.fade_factor(walk.ray.interiors, x, at.hit.t) * x.refraction;
  const bool dispersive = refraction.disperses();
  if (refraction.straight() && !dispersive) {
    walk.ray.ray.origin = at.hit.point;  // the vertex before stays the origin
    ++tracer_.statistics().transmitted_rays;
  } else {
    double ratio = refraction.ratio;
    if (dispersive && !walk.ray.monochromatic) {  // one wavelength for the rest of the path
      const int i = std::min(refraction.samples - 1, static_cast<int>(sequence.next() * refraction.samples));
      walk.weight *= shading::spectral_weight(i, refraction.samples);
      walk.ray.monochromatic = true;
      walk.ray.wavelength = static_cast<float>(shading::spectral_wavelength(i, refraction.samples));
    }
    if (dispersive) ratio = shading::ratio_at(refraction.ratio, refraction.dispersion, walk.ray.wavelength);
    const auto refracted = shading::refracted_direction(walk.ray.ray.direction, top.normal, ratio);
    if (!refracted) {  // total reflection stays inside
      mirror(walk, at, top);
      return true;
    }
    walk.ray.ray = {at.hit.point, normalize(*refracted)};
    walk.origin = {};
    ++tracer_.statistics().refracted_rays;
  }
  refraction.enter(walk.ray);
  walk.ray.primary = false;
  return true;
}

}  // namespace verisim::path
