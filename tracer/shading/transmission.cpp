// What is seen through a surface and in it: entering and leaving interiors, refraction, dispersion, attenuation, mirror
// rays (spec 06 sections 5 and 6).
#include "tracer/math/scaled.h"
#include "tracer/shading/dispersion.h"
#include "tracer/shading/finish.h"
#include "tracer/shading/tracer.h"

namespace verisim::shading {

Color Tracer::transmit(const RayState& ray, SurfaceHit& at, const ShadedLayer& top, float weight,
                       bool& total_reflection) {
  const scene::Interior& x = *at.surface.interior;
  const InteriorScope scope(*this);
  const Refraction refraction = cross_surface(ray, x);
  Color seen;
  if (refraction.straight() && !refraction.disperses()) {
    RayState child = ray.spawn({at.hit.point, ray.ray.direction}, at.level, weight);
    refraction.enter(child);
    child.continuation = true;
    ++statistics_.transmitted_rays;
    seen = trace(child);
  } else if (!refraction.disperses()) {
    seen = refracted_ray(ray, at, top, refraction, refraction.ratio, ray.wavelength, weight, total_reflection);
  } else if (ray.monochromatic) {
    const double ratio = ratio_at(refraction.ratio, refraction.dispersion, ray.wavelength);
    seen = refracted_ray(ray, at, top, refraction, ratio, ray.wavelength, weight, total_reflection);
  } else {
    seen = split_spectrum(ray, at, top, refraction, weight);
  }
  return attenuated(seen, ray.interiors, at, total_reflection);
}

// Of what is seen through a surface.
Color Tracer::attenuated(const Color& seen, const InteriorRange& interiors, const SurfaceHit& at,
                         bool total_reflection) const {
  const scene::Interior& x = *at.surface.interior;
  Rgb attenuation(x.refraction);
  attenuation *= fade_factor(interiors, x, at.hit.t);
  return {seen.rgb() * attenuation, 0, total_reflection ? 0 : seen.t * attenuation.grey()};
}

// The table of spec 06 6.2: only the identity of interiors counts.
Tracer::Refraction Tracer::cross_surface(const RayState& ray, const scene::Interior& x) {
  const auto list = interiors(ray.interiors);
  // POV-Ray divides the numbers of two interiors in single precision, those of one and of empty space in double.
  const auto between = [](const scene::Interior& from, const scene::Interior& to, Refraction& r) {
    r.ratio = static_cast<float>(from.ior / to.ior);
    r.dispersion = static_cast<float>(from.dispersion / to.dispersion);
  };
  Refraction r;
  r.ratio = r.dispersion = 1;
  int samples = x.dispersion_samples;
  if (!list.empty() && list.back() == &x) {
    if (list.size() > 1) {
      const scene::Interior& next = *list[list.size() - 2];
      between(x, next, r);
      samples = std::max(samples, next.dispersion_samples);
    } else {
      r.ratio = x.ior, r.dispersion = x.dispersion;
    }
  } else if (std::find(list.begin(), list.end(), &x) == list.end()) {
    if (!list.empty())
      between(*list.back(), x, r);
    else
      r.ratio = 1.0 / x.ior, r.dispersion = 1.0 / x.dispersion;
  }
  r.samples = samples;
  r.interiors = crossed(ray.interiors, &x);
  r.hollow = all_hollow(r.interiors);
  return r;
}

Color Tracer::refracted_ray(const RayState& ray, SurfaceHit& at, const ShadedLayer& top, const Refraction& refraction,
                            double ratio, float wavelength, float weight, bool& total_reflection) {
  const auto direction = refracted_direction(ray.ray.direction, top.normal, ratio);
  if (!direction) {
    total_reflection = true;
    return reflect(ray, at, top, weight);
  }
  RayState child = ray.spawn({at.hit.point, *direction}, at.level, weight);
  refraction.enter(child);
  child.wavelength = wavelength;
  child.monochromatic = wavelength > 0;
  ++statistics_.refracted_rays;
  return trace(child);
}

Color Tracer::split_spectrum(const RayState& ray, SurfaceHit& at, const ShadedLayer& top, const Refraction& refraction,
                             float weight) {
  const int n = refraction.samples;
  Rgb sum;
  for (int i = 0; i < n; ++i) {
    const double wavelength = spectral_wavelength(i, n);
    bool ignored = false;  // a sub-ray that is totally reflected does not make the hit so; it stays white
    const double ratio = ratio_at(refraction.ratio, refraction.dispersion, wavelength);
    sum += spectral_weight(i, n) *
           refracted_ray(ray, at, top, refraction, ratio, static_cast<float>(wavelength), weight, ignored).rgb();
  }
  return {sum / static_cast<float>(n), 0, 0};
}

Rgb Tracer::reflect(const RayState& ray, SurfaceHit& at, const ShadedLayer& layer, float weight) {
  const Vec3& d = ray.ray.direction;
  RayState child =
      ray.spawn({at.hit.point, reflected_direction(d, layer.normal, at.geometric_normal)}, at.level, weight);
  child.reflected = true;
  ++statistics_.reflected_rays;
  Rgb seen = trace(child).rgb();
  if (const scene::Finish& finish = layer.layer->finish; finish.irid > 0)
    seen *= film_tint(finish, film_thickness(finish, at.hit.point),
                      std::fabs(dot(layer.normal, child.ray.direction)) + std::fabs(dot(layer.normal, d)));
  return seen;
}

bool Tracer::hidden_by_total_reflection(const Vec3& top_normal, const Vec3& normal) {
  const Vec3 difference = normal - top_normal;
  return std::fabs(difference.x) <= kEpsilon && std::fabs(difference.y) <= kEpsilon &&
         std::fabs(difference.z) <= kEpsilon;
}

// What a layer's mirror adds.
Rgb Tracer::mirrored(const RayState& ray, SurfaceHit& at, const ShadedLayer& layer) {
  return mirror_image(layer, reflect(ray, at, layer, ray.weight * layer.translucency * layer.mirror.strength));
}

Rgb Tracer::mirror_image(const ShadedLayer& layer, Rgb seen) {
  const scene::Reflection& r = layer.layer->finish.reflection;
  if (r.exponent != 1) {
    const float e = 1 / r.exponent;
    seen = {std::pow(seen.r, e), std::pow(seen.g, e), std::pow(seen.b, e)};
  }
  return layer.mirror.reflectivity * seen;
}

// Attenuation over the last segment only, and only at surfaces of the interior that is being left (spec 06 6.4).
Rgb Tracer::fade_factor(const InteriorRange& range, const scene::Interior& interior, double distance) const {
  if (std::fabs(interior.fade_distance) <= kEpsilon) return Rgb(1);
  const auto list = interiors(range);
  if (std::find(list.begin(), list.end(), &interior) == list.end()) return Rgb(1);
  const double s = distance / interior.fade_distance;
  const Rgb& c = interior.fade_color;
  const Rgb taken = Rgb(1) - c;
  if (interior.fade_power < 1000)
    return c + scaled(taken, 1 / (1 + std::pow(s, static_cast<double>(interior.fade_power))));
  const Rgb depth = scaled(taken, s);
  const auto passed = [](double x) { return static_cast<float>(std::exp(-x)); };
  return {passed(depth.r), passed(depth.g), passed(depth.b)};
}

// The relative index that fresnel reflection takes; not the one of refraction (spec 06 5.2).
double Tracer::fresnel_ratio(const RayState& ray, const scene::Interior& x) const {
  const auto list = interiors(ray.interiors);
  const double n = x.ior;
  if (list.empty()) return n;
  const double last = list.back()->ior;
  if (std::find(list.begin(), list.end(), &x) == list.end()) return n / last;
  return list.size() == 1 ? 1 / n : last / n;
}

}  // namespace verisim::shading
