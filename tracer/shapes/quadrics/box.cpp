// box (spec 03 4.2).
#include <utility>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_primitive.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-6, kFarthest = 2e10;

enum Face : std::int32_t { x_low, x_high, y_low, y_high, z_low, z_high };

class Box final : public KernelPrimitive<Box> {
 public:
  Box(const scene::Object& description, const Vec3& low, const Vec3& high)
      : KernelPrimitive(description, {Box3(low, high)}), low_(low), high_(high) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    // The direction keeps its length, so distances are those of the world.
    const Vec3 o = local(ray.origin), d = has_matrix() ? matrix().inverse_direction(ray.direction) : ray.direction;
    double near = 0, far = kFarthest;
    std::int32_t near_face = -1, far_face = -1;
    if (!slab<0>(o, d, near, far, near_face, far_face) || !slab<1>(o, d, near, far, near_face, far_face) ||
        !slab<2>(o, d, near, far, near_face, far_face))
      return;
    if (far < kNearest) return;
    const auto report = [&](double t, std::int32_t face) {
      return face >= 0 && sink.add(
                              t, [&] { return ray.origin + t * ray.direction; }, face);
    };
    // Of the two faces at an edge the one that is reported last is seen (spec 03 2.1).
    const bool edge = near == far;
    if (edge && turned_) report(far, far_face);
    if (near > kNearest && report(near, near_face) && Sink::kNearest && !edge) return;
    if (!(edge && turned_)) report(far, far_face);
  }

  void meet(const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) const {
    packet_kernels().box(numbers(), rays, t_min, t_max, met);
  }

  SimpleSolid simple() const override {
    if (guarded()) return {};
    return numbers();
  }

  void turn_hits() { turned_ = true; }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    return p.x >= low_.x && p.x <= high_.x && p.y >= low_.y && p.y <= high_.y && p.z >= low_.z && p.z <= high_.z;
  }

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
            .turned = turned_,
            .matrix = has_matrix() ? &matrix() : nullptr,
            .a = low_,
            .b = high_};
  }

  // Narrows near .. far by one axis. A later axis takes a face over when it wins clearly, or nearly ties and faces the
  // ray more.
  template <int kAxis>
  bool slab(const Vec3& o, const Vec3& d, double& near, double& far, std::int32_t& near_face,
            std::int32_t& far_face) const {
    constexpr int i = kAxis;
    if (std::fabs(d[i]) <= kEpsilon) return o[i] >= low_[i] && o[i] <= high_[i];
    double enter = (low_[i] - o[i]) / d[i], leave = (high_[i] - o[i]) / d[i];
    std::int32_t enter_face = 2 * i, leave_face = 2 * i + 1;
    if (d[i] < 0) std::swap(enter, leave), std::swap(enter_face, leave_face);
    if (enter > leave) return false;
    if (takes_over(enter - near, near_face, d, i)) near_face = enter_face;
    if (takes_over(far - leave, far_face, d, i)) far_face = leave_face;
    if (enter > near) near = enter;
    if (leave < far) far = leave;
    return near <= far;
  }
  static bool takes_over(double gain, std::int32_t face, const Vec3& d, int axis) {
    if (gain > 1e-6) return true;
    return face >= 0 && gain > -1e-6 && std::fabs(d[axis]) > std::fabs(d[face / 2]);
  }

  Vec3 low_, high_;
  bool turned_ = false;
};

}  // namespace

void turn_hits(Shape& shape) {
  if (auto* box = dynamic_cast<Box*>(&shape)) box->turn_hits();
}

std::unique_ptr<Shape> compile_box(const scene::Object& object) {
  const auto& box = *object.as<scene::Box>();
  Vec3 low = box.low, high = box.high;
  for (int i = 0; i < 3; ++i)
    if (low[i] > high[i]) std::swap(low[i], high[i]);
  return std::make_unique<Box>(object, low, high);
}

}  // namespace verisim::shapes
