// sphere (spec 03 4.1).
#include "tracer/shapes/intersections.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_primitive.h"
#include "tracer/shapes/quadrics/quadric_kernels.h"
#include "tracer/shapes/spherical_uv.h"

namespace verisim::shapes {
namespace {

using namespace one_ray;
#include "tracer/shapes/quadrics/sphere_intersections.inc"

Box3 box_of(const scene::Sphere& s) {
  const Vec3 half(std::fabs(s.radius));
  return {s.center - half, s.center + half};
}

class Sphere final : public KernelPrimitive<Sphere> {
 public:
  Sphere(const scene::Object& description, const scene::Sphere& s)
      : KernelPrimitive(description, {box_of(s)}),
        center_(s.center),
        inverse_radius_(1 / s.radius),
        radius2_(s.radius * s.radius),
        uv_transform_(description.uv_transform) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    if (!has_matrix()) {
      sphere_intersections(ray.origin, ray.direction, center_, radius2_, one_ray::Report{[&](double t, std::int32_t) {
                             return sink.add(t, [&] { return ray.origin + t * ray.direction; }) && Sink::kNearest;
                           }});
      return;
    }
    const LocalRay l = local(ray);
    sphere_intersections(l.origin, l.direction, center_, radius2_, one_ray::Report{[&](double t, std::int32_t) {
                           return sink.add(t / l.scale, [&] { return world(l.origin + t * l.direction); }) &&
                                  Sink::kNearest;
                         }});
  }

  void meet(const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) const {
    quadric_kernels().sphere(center_, radius2_, has_matrix() ? &matrix() : nullptr, rays, t_min, t_max, met);
  }
  Vec3 point_of(const PacketHits& met, int k, const Ray& ray) const {
    if (!has_matrix()) return ray.origin + met.t[k] * ray.direction;
    const LocalRay l = local(ray);
    return world(l.origin + met.local[k] * l.direction);
  }

  SimpleSolid simple() const override {
    return {.form = SimpleSolid::Form::sphere,
            .inverted = inverted(),
            .matrix = has_matrix() ? &matrix() : nullptr,
            .a = center_,
            .c = radius2_};
  }

  bool contains(const Vec3& p) const { return distance2(p) < radius2_; }
  // A point exactly on the surface is in neither the sphere nor its complement.
  bool formula(const Vec3& p) const { return inverted() ? distance2(p) > radius2_ : distance2(p) < radius2_; }

  Vec3 geometric_normal(const Hit& hit) const {
    if (has_matrix()) return world_normal(local(hit.point) - center_);
    return (hit.point - center_) * inverse_radius_;  // rounded as POV-Ray does, measured by its photon files
  }

  Vec2 uv(const Hit& hit) const override {
    return spherical_uv(
        normalize(uv_transform_->inverse_point(hit.point) - uv_transform_->inverse_point(world(center_))));
  }

 private:
  double distance2(const Vec3& p) const { return distance2_between(local(p), center_); }

  Vec3 center_;
  double inverse_radius_, radius2_;
  scene::Rare<Transform> uv_transform_;  // shared with the description
};

}  // namespace

std::unique_ptr<Shape> compile_sphere(const scene::Object& object) {
  return std::make_unique<Sphere>(object, *object.as<scene::Sphere>());
}

}  // namespace verisim::shapes
