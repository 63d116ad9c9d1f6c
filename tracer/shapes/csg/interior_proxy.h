// The interior proxy of a convex shape: a ray that begins and ends there does not meet the shape in between. Solids
// with such holes, and skies around a scene, need not be asked what such a ray meets.
#pragma once

#include <optional>

#include "tracer/scene/object.h"

namespace verisim::shapes {

class InteriorProxy {
 public:
  // Of a sphere, box, cone or cylinder without clips and bounds, inverted or not; of others none.
  static std::optional<InteriorProxy> of(const scene::Object& object);

  bool holds(const Vec3& p) const { return to_local_ ? contains(to_local_->inverse_point(p)) : contains(p); }
  // Both ends of a interval of a ray, and therefore all of it.
  bool holds(const Ray& ray, double near, double far) const {
    if (!to_local_) return contains(ray.origin + far * ray.direction) && contains(ray.origin + near * ray.direction);
    const Vec3 origin = to_local_->inverse_point(ray.origin), direction = to_local_->inverse_direction(ray.direction);
    return contains(origin + far * direction) && contains(origin + near * direction);
  }
  bool holds(const Box3& box) const;

 private:
  enum class Form { ball, box, cone };

  InteriorProxy(const scene::Object& object, Form form) : form_(form), to_local_(object.transform) {}
  // Of numbers that are none: false.
  bool contains(const Vec3& p) const {
    const Vec3 q = p - center_;
    switch (form_) {
      case Form::ball:
        return dot(q, q) < radius2_;
      case Form::box:
        return std::fabs(q.x) < half_.x && std::fabs(q.y) < half_.y && std::fabs(q.z) < half_.z;
      default:
        return q.z > low_ && q.z < high_ && q.x * q.x + q.y * q.y < radius2_ + widening_ * (q.z * q.z);
    }
  }

  Form form_;
  scene::Rare<Transform> to_local_;  // shared with the description; absent: none is needed
  Vec3 center_{0, 0, 0}, half_{0, 0, 0};
  double radius2_ = 0, widening_ = 0, low_ = 0, high_ = 0;  // of a cone: between two heights
};

}  // namespace verisim::shapes
