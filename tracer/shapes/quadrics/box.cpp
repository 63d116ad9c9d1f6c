// box (spec 03 4.2).
#include <utility>

#include "tracer/shapes/intersections.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_primitive.h"
#include "tracer/shapes/quadrics/quadric_kernels.h"

namespace verisim::shapes {
namespace {

using namespace one_ray;
#include "tracer/shapes/quadrics/box_intersections.inc"

enum Face : std::int32_t { x_low, x_high, y_low, y_high, z_low, z_high };

class Box final : public KernelPrimitive<Box> {
 public:
  Box(const scene::Object& description, const Vec3& low, const Vec3& high)
      : KernelPrimitive(description, {Box3(low, high)}), low_(low), high_(high) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    // The direction keeps its length, so distances are those of the world.
    const Vec3 o = local(ray.origin), d = has_matrix() ? matrix().inverse_direction(ray.direction) : ray.direction;
    // A list of all hits is turned round by Primitive.
    box_intersections(o, d, low_, high_, hits_turned() && Sink::kNearest,
                      one_ray::Report{[&](double t, std::int32_t face) {
                        const auto point = [&] { return ray.origin + t * ray.direction; };
                        return sink.add(t, point, face) && Sink::kNearest;
                      }});
  }

  void meet(const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) const {
    quadric_kernels().box(numbers(), rays, t_min, t_max, met);
  }

  SimpleSolid simple() const override { return numbers(); }

  bool contains(const Vec3& p) const { return within_box(local(p), low_, high_); }

  Vec3 geometric_normal(const Hit& hit) const {
    Vec3 n(0);
    n[hit.part / 2] = hit.part & 1 ? 1 : -1;
    return has_matrix() ? world_normal(n) : n;
  }

  Vec2 uv(const Hit& hit) const override {
    const Vec3 p = local(hit.point);
    const auto fraction = [&](int i) { return (p[i] - low_[i]) / (high_[i] - low_[i]); };
    const double a = fraction(0), b = fraction(1), c = fraction(2), third = 1.0 / 3;
    switch (hit.part) {
      case x_low:
        return {c / 4, third + b / 3};
      case x_high:
        return {0.75 - c / 4, third + b / 3};
      case y_low:
        return {0.25 + a / 4, c / 3};
      case y_high:
        return {0.25 + a / 4, 1 - c / 3};
      case z_low:
        return {1 - a / 4, third + b / 3};
      default:
        return {0.25 + a / 4, third + b / 3};
    }
  }

 private:
  SimpleSolid numbers() const {
    return {.form = SimpleSolid::Form::box,
            .inverted = inverted(),
            .turned = hits_turned(),
            .matrix = has_matrix() ? &matrix() : nullptr,
            .a = low_,
            .b = high_};
  }

  Vec3 low_, high_;
};

}  // namespace

std::unique_ptr<Shape> compile_box(const scene::Object& object) {
  const auto& box = *object.as<scene::Box>();
  Vec3 low = box.low, high = box.high;
  for (int i = 0; i < 3; ++i)
    if (low[i] > high[i]) std::swap(low[i], high[i]);
  return std::make_unique<Box>(object, low, high);
}

}  // namespace verisim::shapes
