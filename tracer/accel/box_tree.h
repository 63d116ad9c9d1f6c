// A bounding volume hierarchy over boxes: finds the candidates of a ray in single precision, conservatively, so that double precision can decide.
//
// Embree works in binary32. Boxes are stored relative to the centre of all of them and widened by more than the rounding of any ray inside that
// volume; rays are moved to where they enter it before they are rounded. So no candidate is lost, however far away the camera is.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "tracer/math/vec.h"

namespace verisim::accel {

class BoxTree {
 public:
  BoxTree();
  // Empty and unbounded boxes are not allowed; index i of `boxes` is what the visitors get.
  explicit BoxTree(std::span<const Box3> boxes);
  ~BoxTree();
  BoxTree(BoxTree&&) noexcept;
  BoxTree& operator=(BoxTree&&) noexcept;

  bool empty() const { return count_ == 0; }
  Box3 bounds() const { return bounds_; }

  // Calls visit(index, t_max) for every box that the ray meets between t_min and t_max, roughly in order of distance; it returns the new t_max
  // (the same, a smaller one, or minus infinity to stop).
  template <class Visit>
  void traverse(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
    if (count_ == 0) return;
    walk(ray, t_min, t_max, [](void* state, std::uint32_t index, double limit) -> double {
      return (*static_cast<std::remove_reference_t<Visit>*>(state))(index, limit);
    }, &visit);
  }
  // Calls visit(index) for every box that contains p (and perhaps some that narrowly do not) until it returns true. Returns whether one did.
  template <class Visit>
  bool any_around(const Vec3& p, Visit&& visit) const {
    bool found = false;
    traverse({p, {1, 0, 0}}, 0, 0, [&](std::uint32_t index, double t_max) {
      if (!found) found = visit(index);
      return found ? -HUGE_VAL : t_max;
    });
    return found;
  }

 private:
  using Visitor = double (*)(void* state, std::uint32_t index, double t_max);
  void walk(const Ray& ray, double t_min, double t_max, Visitor visitor, void* state) const;

  struct Embree;
  std::unique_ptr<Embree> embree_;  // null: few boxes, which are tested one by one
  std::unique_ptr<Box3[]> boxes_;
  std::size_t count_ = 0;
  Box3 bounds_;
};

// The distances at which a ray enters and leaves a box; false if it misses it within t_min .. t_max, which are narrowed.
inline bool clip_to_box(const Ray& ray, const Box3& box, double& t_min, double& t_max) {
  for (int i = 0; i < 3; ++i) {
    if (ray.direction[i] == 0) {
      if (ray.origin[i] < box.min[i] || ray.origin[i] > box.max[i]) return false;
      continue;
    }
    const double inverse = 1.0 / ray.direction[i];
    double enter = (box.min[i] - ray.origin[i]) * inverse, leave = (box.max[i] - ray.origin[i]) * inverse;
    if (enter > leave) std::swap(enter, leave);
    if (enter > t_min) t_min = enter;
    if (leave < t_max) t_max = leave;
  }
  return t_min <= t_max;
}

inline bool contains(const Box3& box, const Vec3& p) {
  return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y && p.z >= box.min.z && p.z <= box.max.z;
}
inline bool is_finite(const Box3& box) {
  for (int i = 0; i < 3; ++i)
    if (!(std::fabs(box.min[i]) < 1e30 && std::fabs(box.max[i]) < 1e30)) return false;
  return true;
}
inline bool is_empty(const Box3& box) { return !(box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z); }

}  // namespace verisim::accel
