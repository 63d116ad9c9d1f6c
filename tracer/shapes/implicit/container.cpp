#include "tracer/shapes/implicit/container.h"

#include <algorithm>
#include <cmath>

namespace verisim::shapes {

namespace {

constexpr double kBoxFarthest = 2e10, kBoxNearest = 1e-6, kTie = 1e-6;

bool intersect_box(const Vec3& low, const Vec3& high, const Vec3& o, const Vec3& d, ContainerSpan& span) {
  span = {0, kBoxFarthest, 0, 0};
  // Of faces met (almost) together the one that is met more squarely counts.
  double enter_slope = 0, leave_slope = 0;
  for (int k = 0; k < 3; ++k) {
    const double slope = std::fabs(d[k]);
    if (!(slope > kEpsilon)) {
      if (o[k] < low[k] || o[k] > high[k]) return false;
      continue;
    }
    const bool forward = d[k] > 0;
    const double near_t = ((forward ? low[k] : high[k]) - o[k]) / d[k],
                 far_t = ((forward ? high[k] : low[k]) - o[k]) / d[k];
    if (far_t < kBoxNearest) return false;
    if (far_t < span.leave - kTie || (far_t < span.leave + kTie && slope > leave_slope)) {
      span.leave = std::min(span.leave, far_t);
      if (far_t < span.leave + kTie) span.leave_face = 2 * k + (forward ? 2 : 1), leave_slope = slope;
    } else if (far_t < span.leave) {
      span.leave = far_t;
    }
    if (near_t > span.enter + kTie || (near_t > 0 && near_t > span.enter - kTie && slope > enter_slope)) {
      span.enter = std::max(span.enter, near_t);
      span.enter_face = 2 * k + (forward ? 1 : 2), enter_slope = slope;
    } else if (near_t > span.enter) {
      span.enter = near_t;
    }
    if (span.enter > span.leave) return false;
  }
  return true;
}

bool intersect_sphere(const Vec3& center, double radius, const Vec3& o, const Vec3& direction, ContainerSpan& span) {
  const double scale = length(direction);
  const Vec3 d = direction * (1 / scale), to_center = center - o;
  const double closest = dot(to_center, d), distance2 = dot(to_center, to_center), radius2 = radius * radius;
  if (distance2 >= radius2 && closest < kEpsilon) return false;
  const double half2 = radius2 - distance2 + closest * closest;
  if (!(half2 > kEpsilon)) return false;
  const double half = std::sqrt(half2);
  span = {(closest - half) / scale, (closest + half) / scale, 7, 7};
  return true;
}

}  // namespace

bool intersect_container(const scene::Contained& container, const Vec3& origin, const Vec3& direction,
                         ContainerSpan& span) {
  if (container.sphere) return intersect_sphere(container.center, container.radius, origin, direction, span);
  return intersect_box(container.low, container.high, origin, direction, span);
}

bool in_container(const scene::Contained& container, const Vec3& p) {
  if (container.sphere) {
    const Vec3 v = p - container.center;
    return !(dot(v, v) > container.radius * container.radius);
  }
  for (int k = 0; k < 3; ++k) {
    if (p[k] < container.low[k] || p[k] > container.high[k]) return false;
  }
  return true;
}

Vec3 container_normal(const scene::Contained& container, int face, const Vec3& p) {
  if (container.sphere) return (p - container.center) * (1 / container.radius);
  Vec3 n(0, 0, 0);
  if (face > 0 && face < 7) n[(face - 1) / 2] = face % 2 ? -1 : 1;
  return n;
}

Box3 container_box(const scene::Contained& container) {
  if (!container.sphere) return Box3(container.low, container.high);
  const Vec3 r(std::fabs(container.radius));
  return Box3(container.center - r, container.center + r);
}

}  // namespace verisim::shapes
