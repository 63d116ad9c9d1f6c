#include "tracer/lights/light_falloff.h"

#include <algorithm>
#include <cmath>

namespace verisim::shading {
namespace {

bool is_simple(double exponent) { return exponent == 0 || exponent == 1 || exponent == 2; }

}  // namespace

std::optional<LightFalloff> LightFalloff::of(const Light& light) {
  const scene::LightSource& source = light.source();
  LightFalloff f;
  f.spot = source.kind == scene::LightKind::spotlight;
  f.fades = source.fades();
  if ((source.has_beam() && !f.spot) || (f.spot && !is_simple(source.tightness)) ||
      (f.fades && !is_simple(source.fade_power)))
    return std::nullopt;
  f.direction = source.direction, f.tightness = static_cast<int>(f.spot ? source.tightness : 0);
  f.cos_radius = light.cos_radius(), f.cos_falloff = light.cos_falloff(), f.soft_below = light.soft_below();
  f.power = static_cast<int>(f.fades ? source.fade_power : 0), f.fade_distance = source.fade_distance;
  return f;
}

void LightFalloff::attenuate(const RayBatch::Vectors& towards, const double* distance, int count,
                             double* attenuation) const {
  light_falloff_kernels().attenuate(*this, towards, distance, count, attenuation);
}

void aim_at(const Light& light, int count, RayBatch& to_light, double* distance) {
  if (light.radial()) return light_falloff_kernels().aim(light.source().position, count, to_light, distance);
  for (int k = 0; k < count; ++k) {
    const LightDirection direction = light.direction(to_light.origin.at(k));
    to_light.direction.set(k, direction.towards), distance[k] = direction.distance;
  }
}

LightGrid::LightGrid(const Light& light, const Light::Axes& axes)
    : position(light.source().position),
      a1(axes.a1),
      a2(axes.a2),
      last1(light.size1() - 1),
      last2(light.size2() - 1),
      circular(light.source().circular) {
  if (circular) return;
  if (last1 == 0) a1 = Vec3(0, 0, 0), last1 = 1;
  if (last2 == 0) a2 = Vec3(0, 0, 0), last2 = 1;
}

void aim_at_grid(const Light& light, const Light::Axes& axes, const Vec3& p, const GridPlaces& places, int count,
                 RayBatch& to_light, double* distance) {
  if (light.radial())
    return light_falloff_kernels().aim_at_grid(LightGrid(light, axes), p, places, count, to_light, distance);
  for (int k = 0; k < count; ++k) {
    const LightDirection direction = light.direction(p, light.offset(axes, places.u[k], places.v[k]));
    to_light.direction.set(k, direction.towards), distance[k] = direction.distance;
  }
}

}  // namespace verisim::shading
