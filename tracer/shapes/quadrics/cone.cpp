// cone and cylinder (spec 03 4.3). Both are kept in a standard frame: a cylinder has radius 1 and z from 0 to 1; a cone
// has its tip at the origin and its wide end, of radius 1, at z = 1; the narrow end is at z = `narrow` (negative for a
// double cone).
#include "tracer/shapes/quadrics/cone.h"

#include <algorithm>

#include "tracer/shapes/intersections.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/frame.h"
#include "tracer/shapes/packet_primitive.h"
#include "tracer/shapes/quadrics/quadric_kernels.h"

namespace verisim::shapes {
namespace {

using namespace one_ray;
#include "tracer/shapes/quadrics/cone_intersections.inc"

struct Ends {
  Vec3 wide, narrow;
  double radius, len, beyond;  // of the wide end; between the ends; from the tip to the narrow end

  explicit Ends(const scene::Cone& c) {
    const bool cap_is_wide = c.base_radius < c.cap_radius;
    wide = cap_is_wide ? c.cap : c.base, narrow = cap_is_wide ? c.base : c.cap;
    radius = std::max(c.base_radius, c.cap_radius);
    const double narrow_radius = std::min(c.base_radius, c.cap_radius);
    len = length(wide - narrow);
    beyond = narrow_radius * len / (radius - narrow_radius);
  }
};

// A quotient of these lengths, not of the radii: the last bits of hits on the narrow end (spec 03 4.3).
double narrow_end(const scene::Cone& c) {
  if (cone_is_cylinder(c)) return 0;
  const Ends ends(c);
  return ends.beyond / (ends.len + ends.beyond);
}

class Cone final : public KernelPrimitive<Cone> {
 public:
  Cone(const scene::Object& description, const scene::Cone& c)
      : KernelPrimitive(description, {cone_box(c), std::max(c.base_radius, c.cap_radius) > 0}),
        cylinder_(cone_is_cylinder(c)),
        open_(c.open),
        narrow_(narrow_end(c)) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = local(ray);
    cone_intersections(l.origin, l.direction, cylinder_, open_, narrow_,
                       one_ray::Report{[&](double t, std::int32_t part) {
                         const double depth = t / l.scale;
                         sink.add(
                             depth, [&] { return ray.origin + depth * ray.direction; }, part);
                         return false;
                       }});
  }

  void meet(const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) const {
    quadric_kernels().cone(cylinder_, open_, narrow_, has_matrix() ? &matrix() : nullptr, rays, t_min, t_max, met);
  }

  SimpleSolid simple() const override {
    return {.form = SimpleSolid::Form::cone,
            .inverted = inverted(),
            .cylinder = cylinder_,
            .open = open_,
            .matrix = has_matrix() ? &matrix() : nullptr,
            .c = narrow_};
  }

  bool contains(const Vec3& p) const { return within_cone(local(p), cylinder_, open_, narrow_); }

  Vec3 geometric_normal(const Hit& hit) const {
    if (hit.part == kConeWideCap) return world_normal({0, 0, 1});
    if (hit.part == kConeNarrowCap) return world_normal({0, 0, -1});
    const Vec3 p = local(hit.point);
    return world_normal({p.x, p.y, cylinder_ ? 0 : -p.z});
  }

 private:
  bool cylinder_, open_;
  double narrow_;
};

}  // namespace

bool cone_is_cylinder(const scene::Cone& c) {
  const double wide = std::max(c.base_radius, c.cap_radius), narrow = std::min(c.base_radius, c.cap_radius);
  return std::fabs(wide - narrow) < kEpsilon || (wide - narrow) * (wide - narrow) < kEpsilon * wide;
}

Transform cone_frame(const scene::Cone& c) {
  if (cone_is_cylinder(c)) {
    const Vec3 axis = c.base - c.cap;
    const double len = length(axis);
    return frame_along(c.cap, axis * (1.0 / len), std::max(c.base_radius, c.cap_radius), len);
  }
  const Ends ends(c);
  const Vec3 axis = (ends.wide - ends.narrow) * (1.0 / ends.len);
  return frame_along(ends.narrow - ends.beyond * axis, axis, ends.radius, ends.len + ends.beyond);
}

Box3 cone_box(const scene::Cone& c) { return {Vec3(-1, -1, narrow_end(c)), Vec3(1, 1, 1)}; }

std::unique_ptr<Shape> compile_cone(const scene::Object& object) {
  const auto& cone = *object.as<scene::Cone>();
  return compile_in_frame<Cone>(object, cone, cone_frame);
}

}  // namespace verisim::shapes
