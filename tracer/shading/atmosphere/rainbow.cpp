#include "tracer/shading/atmosphere/rainbow.h"

#include "tracer/math/constants.h"

namespace verisim::shading {
namespace {

constexpr double kDegree = kPi / 180;

}  // namespace

Rainbow::Rainbow(const scene::Rainbow& description) : description_(description) {
  active_ = description.colors && description.colors->color_map && !description.colors->color_map->empty() &&
            std::fabs(description.width) > kEpsilon && std::fabs(description.distance) > kEpsilon;
  antisolar_ = normalize(description.direction);
  right_ = normalize(cross(description.up, antisolar_));
  up_ = normalize(cross(antisolar_, right_));
  angle_ = description.angle * kDegree;
  width_ = description.width * kDegree;
  // falloff_angle alone leaves the arc at POV-Ray's raw default of 180 radians.
  const double arc = description.arc_angle ? *description.arc_angle * kDegree : 180.0;
  half_arc_ = arc / 2;
  half_falloff_ = description.falloff_angle ? *description.falloff_angle * kDegree / 2 : half_arc_;
}

// Maps are looked up in the order written (spec 05 section 4.1).
Color Rainbow::color_at(double index) const {
  const scene::ColorMap& map = *description_.colors->color_map;
  if (index >= map.back().position) return map.back().value;
  std::size_t j = 0;
  while (index > map[j].position) ++j;
  if (j == 0 || index == map[j].position) return map[j].value;
  const auto t = static_cast<float>((index - map[j - 1].position) / (map[j].position - map[j - 1].position));
  return map[j - 1].value + t * (map[j].value - map[j - 1].value);
}

bool Rainbow::effect(const Vec3& d, double length, const std::function<double()>& random, Effect& out) const {
  const double along = dot(d, antisolar_);
  if (along < 0) return false;
  const double x = dot(d, right_), y = dot(d, up_), radius = std::sqrt(x * x + y * y);
  const double azimuth = radius > 0 ? std::fabs(std::acos(std::clamp(y / radius, -1.0, 1.0))) : 0;
  if (azimuth > half_arc_) return false;
  double index = (std::acos(std::clamp(along, -1.0, 1.0)) - (angle_ - width_ / 2)) / width_;
  if (description_.jitter > 0) index += (2 * random() - 1) * description_.jitter;
  if (index < 0 || index > 1 - kEpsilon) return false;
  const Color c = color_at(index);
  double fade = 0;
  if (azimuth > half_falloff_ && half_arc_ != half_falloff_) {
    const double v = (azimuth - half_falloff_) / (half_arc_ - half_falloff_);
    fade = v * v * (3 - 2 * v);
  }
  const double keep = std::max(std::exp(-length / description_.distance), fade * (1 - c.t) + c.t);
  out.keep = static_cast<float>(keep);
  const float filter = c.f * (1 - out.keep);
  out.filter = Rgb(1 - filter) + filter * c.rgb();
  out.added = (1 - out.keep) * c.rgb();
  out.see_through = out.keep * c.t;
  return true;
}

}  // namespace verisim::shading
