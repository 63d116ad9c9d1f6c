// cone and cylinder (spec 03 4.3). Both are kept in a standard frame: a cylinder has radius 1 and z from 0 to 1; a cone
// has its tip at the origin and its wide end, of radius 1, at z = 1; the narrow end is at z = `narrow` (negative for a
// double cone).
#include "tracer/shapes/quadrics/cone.h"

#include <algorithm>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/frame.h"
#include "tracer/shapes/packet_primitive.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-9, kFarthest = 1e7;  // of local distances

double narrow_end(const scene::Cone& c) {
  if (cone_is_cylinder(c)) return 0;
  return std::min(c.base_radius, c.cap_radius) / std::max(c.base_radius, c.cap_radius);
}

enum Part : std::int32_t { wall, narrow_cap, wide_cap };

class Cone final : public KernelPrimitive<Cone> {
 public:
  Cone(const scene::Object& description, const scene::Cone& c)
      : KernelPrimitive(description, {cone_box(c)}),
        cylinder_(cone_is_cylinder(c)),
        open_(c.open),
        narrow_(narrow_end(c)) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = local(ray);
    const Vec3 &o = l.origin, &d = l.direction;
    const auto report = [&](double t, Part part) {
      if (!(t > kNearest && t < kFarthest)) return;
      const double depth = t / l.scale;
      sink.add(
          depth, [&] { return ray.origin + depth * ray.direction; }, part);
    };
    const auto report_wall = [&](double t) {
      const double z = o.z + t * d.z;
      if (z >= narrow_ && z <= 1) report(t, wall);
    };
    if (cylinder_) {
      const double a = d.x * d.x + d.y * d.y;
      if (a > kEpsilon) {
        const double b = o.x * d.x + o.y * d.y, c = o.x * o.x + o.y * o.y - 1;
        const double discriminant = b * b - a * c;
        if (discriminant >= 0) {
          const double root = std::sqrt(discriminant);
          report_wall((-b + root) / a);
          report_wall((-b - root) / a);
        } else if (open_) {
          return;
        }
      }
    } else {
      const double a = d.x * d.x + d.y * d.y - d.z * d.z, b = o.x * d.x + o.y * d.y - o.z * d.z,
                   c = o.x * o.x + o.y * o.y - o.z * o.z;
      if (std::fabs(a) < kEpsilon) {
        if (std::fabs(b) > kEpsilon) report_wall(-0.5 * c / b);
      } else {
        const double discriminant = b * b - a * c;
        if (discriminant >= 0) {
          const double root = std::sqrt(discriminant);
          report_wall((-b - root) / a);
          report_wall((-b + root) / a);
        }
      }
    }
    if (open_ || !(std::fabs(d.z) > kEpsilon)) return;
    const auto report_cap = [&](double z, double radius2, Part part) {
      const double t = (z - o.z) / d.z;
      const double x = o.x + t * d.x, y = o.y + t * d.y;
      if (x * x + y * y <= radius2) report(t, part);
    };
    report_cap(1, 1, wide_cap);
    report_cap(narrow_, cylinder_ ? 1 : narrow_ * narrow_, narrow_cap);
  }

  void meet(const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) const {
    packet_kernels().cone(cylinder_, open_, narrow_, has_matrix() ? &matrix() : nullptr, rays, t_min, t_max, met);
  }

  SimpleSolid simple() const override {
    if (guarded()) return {};
    return {.form = SimpleSolid::Form::cone,
            .inverted = inverted(),
            .cylinder = cylinder_,
            .open = open_,
            .matrix = has_matrix() ? &matrix() : nullptr,
            .c = narrow_};
  }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    const double r2 = p.x * p.x + p.y * p.y, limit2 = cylinder_ ? 1 : p.z * p.z;
    // The closed solid is smaller than its surface by epsilon, the open one larger.
    const double e = open_ ? kEpsilon : -kEpsilon;
    return r2 <= limit2 + e && p.z >= narrow_ - e && p.z <= 1 + e;
  }

  Vec3 geometric_normal(const Hit& hit) const {
    if (hit.part == wide_cap) return world_normal({0, 0, 1});
    if (hit.part == narrow_cap) return world_normal({0, 0, -1});
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
  const bool cap_is_wide = c.base_radius < c.cap_radius;
  if (cone_is_cylinder(c)) {
    const Vec3 axis = c.base - c.cap;
    const double len = length(axis);
    return frame_along(c.cap, axis * (1.0 / len), std::max(c.base_radius, c.cap_radius), len);
  }
  const Vec3 wide = cap_is_wide ? c.cap : c.base, narrow = cap_is_wide ? c.base : c.cap;
  const double wide_radius = std::max(c.base_radius, c.cap_radius),
               narrow_radius = std::min(c.base_radius, c.cap_radius);
  const double len = length(wide - narrow);
  const Vec3 axis = (wide - narrow) * (1.0 / len);
  const double beyond = narrow_radius * len / (wide_radius - narrow_radius);  // from the tip to the narrow end
  return frame_along(narrow - beyond * axis, axis, wide_radius, len + beyond);
}

Box3 cone_box(const scene::Cone& c) { return {Vec3(-1, -1, narrow_end(c)), Vec3(1, 1, 1)}; }

std::unique_ptr<Shape> compile_cone(const scene::Object& object) {
  const auto& cone = *object.as<scene::Cone>();
  return compile_in_frame<Cone>(object, cone, cone_frame);
}

}  // namespace verisim::shapes
