// quadric (spec 03 4.10): coefficients are kept in world space.
#include "tracer/shapes/intersections.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_primitive.h"
#include "tracer/shapes/quadrics/quadric_kernels.h"
#include "tracer/shapes/quadrics/quadric_box.h"

namespace verisim::shapes {
namespace {

using namespace one_ray;
#include "tracer/shapes/quadrics/quadric_intersections.inc"

// Of {value <= 0} or, for a quadric written with negative coefficients, of {value >= 0}. POV-Ray's boxes depend on
// clips and are partly wrong (4.11).
bool negative(const scene::Quadric& q) {
  for (int i = 0; i < 3; ++i)
    if (q.square[i] != 0) return q.square[i] < 0;
  return false;
}
Box3 box_of(scene::Quadric q) {
  if (negative(q)) q.square = -q.square, q.mixed = -q.mixed, q.linear = -q.linear, q.constant = -q.constant;
  return narrowed(everywhere(), q);
}

// Whether the side a box can describe is the one the inverted mark says.
bool box_tells_solid(const scene::Object& object, const scene::Quadric& q) { return negative(q) == object.inverted; }

class Quadric final : public KernelPrimitive<Quadric> {
 public:
  Quadric(const scene::Object& description, const scene::Quadric& q)
      : KernelPrimitive(description, {box_of(q), box_tells_solid(description, q)}), q_(q) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    quadric_intersections(ray.origin, ray.direction, q_, one_ray::Report{[&](double t, std::int32_t) {
                            sink.add(t, [&] { return ray.origin + t * ray.direction; });
                            return false;
                          }});
  }

  void meet(const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) const {
    quadric_kernels().quadric(q_, rays, t_min, t_max, met);
  }

  SimpleSolid simple() const override { return {.form = SimpleSolid::Form::quadric, .quadric = &q_}; }

  // Inversion has negated the coefficients already.
  bool contains(const Vec3& p) const { return quadric_inside(q_, p); }
  bool formula(const Vec3& p) const { return contains(p); }

  Vec3 geometric_normal(const Hit& hit) const {
    const Vec3 &p = hit.point, &s = q_.square, &m = q_.mixed, &l = q_.linear;
    const Vec3 gradient(2 * s.x * p.x + m.x * p.y + m.y * p.z + l.x, m.x * p.x + 2 * s.y * p.y + m.z * p.z + l.y,
                        m.y * p.x + m.z * p.y + 2 * s.z * p.z + l.z);
    return gradient == Vec3(0) ? Vec3(1, 0, 0) : normalize(gradient);
  }

 private:
  scene::Quadric q_;
};

}  // namespace

std::unique_ptr<Shape> compile_quadric(const scene::Object& object) {
  return std::make_unique<Quadric>(object, *object.as<scene::Quadric>());
}

}  // namespace verisim::shapes
