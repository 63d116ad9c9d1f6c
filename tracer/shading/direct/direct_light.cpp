// Light sources on one layer: facing, shadows, diffuse reflection, highlights, iridescence (spec 06 sections 4.2
// and 8.3).
#include "tracer/math/ray_batch.h"
#include "tracer/math/scaled.h"
#include "tracer/shading/finish.h"
#include "tracer/shading/direct/shadow_batch.h"
#include "tracer/shading/tracer.h"
#include "tracer/noise/noise.h"

namespace verisim::shading {

void Tracer::add_direct_light(const RayState& ray, SurfaceHit& at, const LayerContext& layer, Rgb& sum) {
  const scene::Finish& finish = layer.layer.finish;
  if (!reflects_light(finish) || !ray.direct_light) return;
  const auto add = [&](const Light& light, CachedLight& cache) {
    if (!observer_) return add_light(ray, at, layer, light, cache, sum);
    const Rgb before = sum;
    RandomSource numbers = random_;  // who tells apart what was added must draw them once more (crand)
    add_light(ray, at, layer, light, cache, sum);
    std::swap(random_, numbers);
    tell_light(ray, at, layer, light, cache, sum - before);
    random_ = numbers;
  };
  if (!at.surface.ignore_global_lights && lights_go_together(ray)) {
    add_lights_together(ray, at, layer, sum);
  } else if (!at.surface.ignore_global_lights) {
    for (std::size_t i = 0; i < scene_.global_lights(); ++i) {
      // Shadow rays may push onto the cache of nested hits: copy in, copy back.
      CachedLight cache;
      if (at.keeps_lights) cache = light_cache_[at.light_cache + i];
      add(scene_.lights()[i], cache);
      if (at.keeps_lights) light_cache_[at.light_cache + i] = cache;
    }
  }
  for (const scene::LightSource* source : at.surface.group_lights()) {
    CachedLight cache;
    add(scene_.light_of(source), cache);
  }
}

void Tracer::tell_light(const RayState& ray, const SurfaceHit& at, const LayerContext& layer, const Light& light,
                        const CachedLight& cache, const Rgb& added) {
  Rgb highlight;
  const scene::Finish& finish = layer.layer.finish;
  const bool shiny = light.highlights() && (finish.phong != 0 || finish.specular != 0);
  const bool one_direction = !(light.area_illumination() && light.area());  // else parts are not told apart
  if (shiny && one_direction && added != Rgb()) {
    const bool back = !at.surface.double_illuminate && dot(layer.normal, cache.direction.towards) < kEpsilon;
    highlight = added - layer_response(at, layer, ray.ray.direction, cache.direction.towards, cache.color,
                                       back ? finish.diffuse_back : finish.diffuse, false);
  }
  observer_->light(light, cache.direction, cache.stage == CachedLight::Stage::shadowed, cache.color, added, highlight);
}

bool Tracer::lights_go_together(const RayState& ray) const {
  constexpr std::size_t kMin = 3;  // lights for which a batch costs less than one ray for each
  return lights_in_batches_ && scene_.global_lights() >= kMin && (ray.gather || !area_lights_) && !observer_;
}

// add_light() of all global lights. Nothing on the ways of these shadow rays draws random numbers, so they may
// go at once.
void Tracer::add_lights_together(const RayState& ray, SurfaceHit& at, const LayerContext& layer, Rgb& sum) {
  struct Active {
    std::size_t light;
    CachedLight cache;
    bool back, shadow;
  };
  constexpr std::size_t kMax = RayBatch::kMax;
  const scene::Finish& finish = layer.layer.finish;
  Active active[kMax];
  RayBatch rays;
  double limit[RayBatch::kSize];
  for (std::size_t next = 0; next < scene_.global_lights();) {
    std::size_t count = 0;
    int batch = 0;
    for (; next < scene_.global_lights() && count < kMax; ++next) {
      const Light& light = scene_.lights()[next];
      Active& a = active[count];
      a = {next, {}, false, false};
      if (at.keeps_lights) a.cache = light_cache_[at.light_cache + next];
      const bool counts = locate(at, layer, light, a.cache, a.back);
      if (counts) {
        ++count;
        a.shadow = a.cache.stage == CachedLight::Stage::located && light.shadows();
        a.cache.stage = CachedLight::Stage::shadowed;
        if (a.shadow) {
          ++statistics_.shadow_rays;
          a.shadow = a.cache.direction.distance > 2 * kShadowTolerance;
        }
        if (a.shadow) {
          rays.origin.set(batch, at.hit.point), rays.direction.set(batch, a.cache.direction.towards);
          limit[batch++] = a.cache.direction.distance - kShadowTolerance;
        }
      } else if (at.keeps_lights) {
        light_cache_[at.light_cache + next] = a.cache;
      }
    }
    bool blocked[kMax] = {};
    if (batch > 0) scene_.world.occluded_batch(rays, 0, batch, kContactTolerance, limit, nullptr, blocked);
    batch = 0;
    for (std::size_t k = 0; k < count; ++k) {
      Active& a = active[k];
      if (a.shadow && blocked[batch++]) a.cache.color = {};
      if (at.keeps_lights) light_cache_[at.light_cache + a.light] = a.cache;
      if (a.cache.color.max_abs() <= kDark) continue;
      const bool highlights = scene_.lights()[a.light].highlights() && !ray.gather && !a.back;
      sum += layer_response(at, layer, ray.ray.direction, a.cache.direction.towards, a.cache.color,
                            a.back ? finish.diffuse_back : finish.diffuse, highlights);
    }
  }
}

bool Tracer::locate(SurfaceHit& at, const LayerContext& layer, const Light& light, CachedLight& cache,
                    bool& back) const {
  if (cache.stage == CachedLight::Stage::unknown) {
    cache.direction = light.direction(at.hit.point);
    cache.color = scaled(light.color(), light.attenuation(at.hit.point, cache.direction));
    cache.stage = CachedLight::Stage::located;
  }
  if (cache.color.max_abs() < kDark) return false;
  back = !at.surface.double_illuminate && !light.area_illumination() &&
         dot(layer.normal, cache.direction.towards) < kEpsilon;
  return !back || layer.layer.finish.diffuse_back != 0;
}

void Tracer::add_light(const RayState& ray, SurfaceHit& at, const LayerContext& layer, const Light& light,
                       CachedLight& cache, Rgb& sum) {
  if (light.area_illumination() && light.area() && !ray.gather)
    return add_area_illumination(ray, at, layer, light, cache, sum);
  bool back = false;
  if (!locate(at, layer, light, cache, back)) return;
  const scene::Finish& finish = layer.layer.finish;
  if (cache.stage == CachedLight::Stage::located) {
    const RandomBranch branch(random_, RandomBranch::light(static_cast<std::size_t>(&light - scene_.lights().data())));
    cache.color = shadowed(light, at.hit.point, cache.direction, ray, &at.surface, cache.color);
    cache.stage = CachedLight::Stage::shadowed;
  }
  if (cache.color.max_abs() <= kDark) return;
  sum += layer_response(at, layer, ray.ray.direction, cache.direction.towards, cache.color,
                        back ? finish.diffuse_back : finish.diffuse, light.highlights() && !ray.gather && !back);
}

// Illumination from every sample of the grid; the shadow is one for all (spec 06 8.3).
void Tracer::add_area_illumination(const RayState& ray, SurfaceHit& at, const LayerContext& layer, const Light& light,
                                   CachedLight& cache, Rgb& sum) {
  const scene::Finish& finish = layer.layer.finish;
  const Vec3& p = at.hit.point;
  if (cache.stage != CachedLight::Stage::shadowed) {
    cache.direction = light.direction(p);
    cache.color = shadowed(light, p, cache.direction, ray, &at.surface, light.color());
    cache.stage = CachedLight::Stage::shadowed;
  }
  if (cache.color.max_abs() <= kDark) return;
  const Light::Axes axes = light.axes(cache.direction.towards);
  const Rgb film = film_tint(at, layer, ray.ray.direction, cache.direction.towards);  // one for all samples
  const Rgb part = cache.color / (static_cast<float>(light.size1()) * static_cast<float>(light.size2()));
  for (int v = 0; v < light.size2(); ++v) {
    for (int u = 0; u < light.size1(); ++u) {
      double du = u, dv = v;
      if (light.source().jitter) du += random_.shading() - 0.5, dv += random_.shading() - 0.5;
      const LightDirection direction = light.direction(p, light.offset(axes, du, dv));
      const Rgb color = scaled(part, light.attenuation(p, direction));
      bool back = false;
      if (!at.surface.double_illuminate && dot(layer.normal, direction.towards) < kEpsilon) {
        if (finish.diffuse_back == 0) continue;
        back = true;
      }
      sum += film * response_below_film(layer, ray.ray.direction, direction.towards, color,
                                        back ? finish.diffuse_back : finish.diffuse,
                                        light.highlights() && !ray.gather && !back);
    }
  }
}

Rgb Tracer::layer_response(const SurfaceHit& at, const LayerContext& layer, const Vec3& view, const Vec3& l,
                           const Rgb& intensity, float diffuse, bool highlights) {
  const Rgb sum = response_below_film(layer, view, l, intensity, diffuse, highlights);
  return layer.layer.finish.irid > 0 ? sum * film_tint(at, layer, view, l) : sum;
}

Rgb Tracer::response_below_film(const LayerContext& layer, const Vec3& view, const Vec3& l, const Rgb& intensity,
                                float diffuse, bool highlights) {
  const scene::Finish& finish = layer.layer.finish;
  const Rgb pigment = layer.pigment.rgb();
  const double cosine = dot(layer.normal, l);
  Rgb sum;
  const bool replaced = finish.subsurface && scene_.effects && scene_.effects->subsurface;
  if (diffuse > 0 && !replaced) {
    double s = diffuse_share(layer.opacity, diffuse, finish.brilliance, cosine);
    if (finish.crand > 0) s -= finish.crand * random_.crand();
    sum += scaled(pigment, s) * intensity;
  }
  if (highlights && has_highlight(finish)) {
    const Rgb color = finish.metallic > 0 ? intensity * metallic_tint(pigment, finish.metallic, cosine) : intensity;
    for (const double strength : highlight_strengths(finish, layer.normal, view, l))
      if (strength != 0) sum += scaled(color, strength);
  }
  return sum;
}

double Tracer::film_thickness(const scene::Finish& finish, const Vec3& p) const {
  if (finish.irid_turbulence == 0) return finish.irid_thickness;
  static const textures::Octaves octaves = film_octaves();
  return turbulent_thickness(finish, textures::turbulence(p, octaves, scene_.scene.settings.noise_generator));
}

Rgb Tracer::film_tint(const SurfaceHit& at, const LayerContext& layer, const Vec3& view, const Vec3& l) const {
  const scene::Finish& finish = layer.layer.finish;
  if (!(finish.irid > 0)) return Rgb(1);
  const double cosines = std::fabs(dot(layer.normal, l)) + std::fabs(dot(layer.normal, view));
  return film_tint(finish, film_thickness(finish, at.hit.point), cosines);
}

Rgb Tracer::film_tint(const scene::Finish& finish, double thickness, double cosines) const {
  return iridescence(finish.irid, thickness, cosines, scene_.scene.settings.irid_wavelength);
}

Rgb Tracer::light_at(const Light& light, const Vec3& p, const RayState& ray, bool in_air, Vec3& to_light) {
  const LightDirection direction = light.direction(p);
  to_light = direction.towards;
  const bool fades = in_air ? light.attenuates_air() : light.attenuates();
  const Rgb color = fades ? scaled(light.color(), light.attenuation(p, direction)) : light.color();
  return color.max_abs() < kDark ? Rgb() : shadowed(light, p, direction, ray, nullptr, color);
}

}  // namespace verisim::shading
