// sphere (spec 03 4.1).
#include <numbers>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_primitive.h"
#include "tracer/shapes/spherical_uv.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-6, kFarthest = 1e7;

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
    double near, far;
    if (!has_matrix()) {
      if (!solve(ray.origin, ray.direction, near, far)) return;
      if (near > kNearest && near < kFarthest) {
        const bool accepted = sink.add(near, [&] { return ray.origin + near * ray.direction; });
        if (Sink::kNearest && accepted) return;
      }
      if (far > kNearest && far < kFarthest) sink.add(far, [&] { return ray.origin + far * ray.direction; });
      return;
    }
    const LocalRay l = local(ray);
    if (!solve(l.origin, l.direction, near, far)) return;
    for (const double t : {near, far}) {
      if (!(t > kNearest && t < kFarthest)) continue;
      const bool accepted = sink.add(t / l.scale, [&] { return world(l.origin + t * l.direction); });
      if (Sink::kNearest && accepted) return;
    }
  }

  void meet(const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) const {
    packet_kernels().sphere(center_, radius2_, has_matrix() ? &matrix() : nullptr, rays, t_min, t_max, met);
  }
  Vec3 point_of(const PacketHits& met, int k, const Ray& ray) const {
    if (!has_matrix()) return ray.origin + met.t[k] * ray.direction;
    const LocalRay l = local(ray);
    return world(l.origin + met.local[k] * l.direction);
  }

  SimpleSolid simple() const override {
    if (guarded()) return {};
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
  double distance2(const Vec3& p) const {
    const Vec3 d = local(p) - center_;
    return dot(d, d);
  }

  bool solve(const Vec3& origin, const Vec3& direction, double& near, double& far) const {
    const Vec3 to_center = center_ - origin;
    const double distance_squared = dot(to_center, to_center), closest = dot(to_center, direction);
    if (distance_squared >= radius2_ && closest < kEpsilon) return false;
    const double half_chord2 = radius2_ - distance_squared + closest * closest;
    if (!(half_chord2 > kEpsilon)) return false;
    const double half_chord = std::sqrt(half_chord2);
    near = closest - half_chord;
    far = closest + half_chord;
    return true;
  }

  Vec3 center_;
  double inverse_radius_, radius2_;
  scene::Rare<Transform> uv_transform_;  // shared with the description
};

}  // namespace

std::unique_ptr<Shape> compile_sphere(const scene::Object& object) {
  return std::make_unique<Sphere>(object, *object.as<scene::Sphere>());
}

}  // namespace verisim::shapes
