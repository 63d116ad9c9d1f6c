#include "tracer/lights/light.h"

#include "tracer/math/constants.h"

namespace verisim::shading {

Light::Light(const scene::LightSource& source, bool area_lights, std::unique_ptr<shapes::Shape> projector)
    : source_(&source), area_(source.area && area_lights), projector_(std::move(projector)) {
  radial_ = !source.parallel && source.kind != scene::LightKind::cylinder;
  attenuates_ = source.has_beam() || source.fades();
  parallel_ = (source.parallel || source.kind == scene::LightKind::cylinder) && !area_;
  if (!area_) {
    box_ = Box3(source.position);
  } else if (!source.parallel && source.kind != scene::LightKind::cylinder) {
    // Samples stand within half an axis of the centre, and half a step beyond with jitter.
    const auto reach = [&](int size) { return size > 1 ? 0.51 + (source.jitter ? 0.5 / (size - 1) : 0) : 0.01; };
    const double r1 = reach(source.size1), r2 = reach(source.size2);
    for (int i = 0; i < 3; ++i) {
      const double r = source.orient ? (r1 + r2) * length(source.axis1)
                                     : r1 * std::fabs(source.axis1[i]) + r2 * std::fabs(source.axis2[i]);
      box_.min[i] = source.position[i] - r, box_.max[i] = source.position[i] + r;
    }
  }
  cos_radius_ = std::cos(source.radius * kPi / 180);
  cos_falloff_ = std::cos(source.falloff * kPi / 180);
}

LightDirection Light::fixed_direction(const Vec3& p, const Vec3& centre) const {
  const bool along_axis = source_->kind == scene::LightKind::cylinder || area_;
  const Vec3 l = along_axis ? normalize(centre - source_->point_at) : -source_->direction;
  return {l, dot(centre - p, l)};
}

namespace {

// pow, without its cost for the common exponents.
double raised(double base, double exponent) {
  if (exponent == 0) return 1;
  if (exponent == 2) return base * base;
  return exponent == 1 ? base : std::pow(base, exponent);
}

}  // namespace

double Light::angle_and_distance(const Vec3& p, const LightDirection& l) const {
  double a = source_->has_beam() ? profile(p, l) : 1;
  if (a == 0) return 0;
  if (source_->fades()) a *= faded(raised(l.distance / source_->fade_distance, source_->fade_power));
  return a;
}

double Light::profile(const Vec3& p, const LightDirection& l) const {
  switch (source_->kind) {
    case scene::LightKind::spotlight:
      return spot(l);
    case scene::LightKind::cylinder:
      return cylinder(p);
    case scene::LightKind::point:
    case scene::LightKind::shadowless:
      break;
  }
  return 1;
}

double Light::spot(const LightDirection& l) const {
  const double along = dot(l.towards, source_->direction), m = l.distance > 0 ? -along : along;
  if (m <= 0) return 0;
  return spot_profile(m, raised(m, source_->tightness), cos_falloff_, cos_radius_, soft_below());
}

double Light::cylinder(const Vec3& p) const {
  const Vec3 from = p - source_->position;
  const double k = dot(from, source_->direction);
  if (k <= 0) return 0;
  const double l = length(from - source_->direction * k);
  if (l >= source_->falloff) return 0;
  const double e = 1 - l / source_->falloff;
  double a = raised(e, source_->tightness);
  if (source_->radius > 0 && l > source_->radius) a *= smooth_step(0, 1 - source_->radius / source_->falloff, e);
  return a;
}

double Light::emission(const Vec3& origin, const Vec3& direction) const {
  // Photons keep within the falloff of a spotlight, be its radius wider or not; illumination reaches to the wider one
  // (spec 07 3.5).
  const bool outside =
      source_->kind == scene::LightKind::spotlight && dot(direction, source_->direction) < cos_falloff_;
  return outside ? 0 : profile(origin + direction, {-direction, 1.0});
}

Light::Axes Light::axes(const Vec3& l) const {
  if (!source_->orient) return {source_->axis1, source_->axis2};
  const Vec3 e = std::fabs(std::fabs(l.z) - 1) < 0.01 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  const double size = length(source_->axis1);
  // Divided by their lengths, unlike other vectors (spec 06 8.1).
  const Vec3 across = cross(l, e), a1 = across / length(across), up = cross(l, a1);
  return {size * a1, size * (up / length(up))};
}

Vec3 Light::offset(const Axes& axes, double u, double v) const {
  if (source_->circular) {
    const double a = u / (size1() - 1) - 0.5, b = v / (size2() - 1) - 0.5;
    return disc_offset(axes.a1, axes.a2, a, b);
  }
  Vec3 result(0, 0, 0);
  if (size1() > 1) result += axes.a1 * (u / (size1() - 1) - 0.5);
  if (size2() > 1) result += axes.a2 * (v / (size2() - 1) - 0.5);
  return result;
}

}  // namespace verisim::shading
