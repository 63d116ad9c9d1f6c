// plane (spec 03 4.5).
#include "tracer/shapes/quadrics/plane.h"

#include "tracer/shapes/factories.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {
namespace {

class Plane final : public Primitive<Plane> {
 public:
  Plane(const scene::Object& description, const scene::Plane& p)
      : Primitive(description, {everywhere(), false}), normal_(p.normal), distance_(p.distance) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    // With a matrix the local direction is not normalised, so distances are those of the world.
    const Vec3 o = local(ray.origin), d = has_matrix() ? matrix().inverse_direction(ray.direction) : ray.direction;
    double slope, t;
    if (one_ray::plane_intersection(normal_, distance_, o, d, slope, t))
      sink.add(t, [&] { return ray.origin + t * ray.direction; });
  }

  SimpleSolid simple() const override {
    return {.form = SimpleSolid::Form::plane,
            .inverted = inverted(),
            .matrix = has_matrix() ? &matrix() : nullptr,
            .a = normal_,
            .c = distance_};
  }

  bool contains(const Vec3& p) const { return one_ray::within_plane(normal_, distance_, local(p)); }
  Vec3 geometric_normal(const Hit&) const { return has_matrix() ? world_normal(normal_) : normal_; }

 private:
  Vec3 normal_;
  double distance_;
};

}  // namespace

std::unique_ptr<Shape> compile_plane(const scene::Object& object) {
  return std::make_unique<Plane>(object, *object.as<scene::Plane>());
}

}  // namespace verisim::shapes
