// A bounding volume hierarchy over boxes: finds the candidates of a ray in single precision, conservatively, so that double precision can decide.
//
// Embree builds the tree (surface area heuristic, four children a node); the walk is ours, because the visitor (a shape's own intersection test) is
// inlined into it and because it must not lose a candidate: boxes are stored in binary32 relative to the centre of all of them and widened by more
// than the rounding of any ray inside that volume, and rays are moved to where they enter it before they are rounded.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "tracer/accel/box_node.h"
#include "tracer/math/vec.h"

namespace verisim::accel {

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

class BoxTree {
 public:
  BoxTree() = default;
  // Empty and unbounded boxes are not allowed; index i of `boxes` is what the visitors get.
  explicit BoxTree(std::span<const Box3> boxes);

  bool empty() const { return nodes_.empty(); }

  // Calls visit(index, t_max) for every box that the ray meets between t_min and t_max, roughly in order of distance; it returns the new t_max
  // (the same, a smaller one, or minus infinity to stop).
  template <class Visit>
  void traverse(const Ray& ray, double t_min, double t_max, Visit&& visit) const;
  // Calls visit(index) for every box that contains p (and perhaps some that narrowly do not) until it returns true. Returns whether one did.
  template <class Visit>
  bool any_around(const Vec3& p, Visit&& visit) const;

 private:
  static constexpr int kStackSize = 256;

  std::vector<BoxNode> nodes_;  // the first is the root
  Box3 bounds_;                 // of all, widened
  Vec3 center_{0, 0, 0};
  double slack_ = 0;
};

template <class Visit>
void BoxTree::traverse(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
  if (nodes_.empty()) return;
  const Vec3 inverse(1.0 / ray.direction.x, 1.0 / ray.direction.y, 1.0 / ray.direction.z);
  double start = t_min, end = t_max;
  for (int i = 0; i < 3; ++i) {
    // A zero direction makes infinities of the right signs, or NaN on the very face, which the comparisons ignore.
    double enter = (bounds_.min[i] - ray.origin[i]) * inverse[i], leave = (bounds_.max[i] - ray.origin[i]) * inverse[i];
    if (enter > leave) std::swap(enter, leave);
    if (enter > start) start = enter;
    if (leave < end) end = leave;
  }
  if (!(start <= end)) return;
  const NodeRay node_ray(ray.origin - center_ + start * ray.direction, inverse);
  // Distances in the walk count from `start`.
  float far = round_up(end - start + slack_);

  struct Entry {
    std::uint32_t child;
    float near;
  };
  Entry stack[kStackSize];
  int size = 0;
  std::uint32_t child = 0;
  for (;;) {
    while (!(child & BoxNode::kLeaf)) {
      alignas(16) float near[4];
      const BoxNode& node = nodes_[child];
      unsigned hits = node_ray.test(node, far, near);
      if (hits == 0) goto next;
      // The nearest child is next; the others wait, the nearer ones on top.
      int k = __builtin_ctz(hits);
      hits &= hits - 1;
      child = node.child[k];
      float nearest = near[k];
      const int first = size;
      while (hits != 0) {
        k = __builtin_ctz(hits);
        hits &= hits - 1;
        Entry other{node.child[k], near[k]};
        if (other.near < nearest) {
          std::swap(other.child, child);
          std::swap(other.near, nearest);
        }
        int place = size++;
        while (place > first && stack[place - 1].near < other.near) {
          stack[place] = stack[place - 1];
          --place;
        }
        stack[place] = other;
      }
    }
    {
      const double limit = visit(child & ~BoxNode::kLeaf, t_max);
      if (limit < t_max) {
        t_max = limit;
        if (t_max < t_min) return;
        far = round_up(t_max - start + slack_);
      }
    }
  next:
    do {
      if (size == 0) return;
      --size;
    } while (stack[size].near > far);
    child = stack[size].child;
  }
}

template <class Visit>
bool BoxTree::any_around(const Vec3& p, Visit&& visit) const {
  if (nodes_.empty() || !contains(bounds_, p)) return false;
  const Vec3 q = p - center_;
  const float x = static_cast<float>(q.x), y = static_cast<float>(q.y), z = static_cast<float>(q.z);
  std::uint32_t stack[kStackSize];
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t child = stack[--size];
    if (child & BoxNode::kLeaf) {
      if (visit(child & ~BoxNode::kLeaf)) return true;
      continue;
    }
    const BoxNode& node = nodes_[child];
    for (unsigned hits = boxes_around(node, x, y, z); hits != 0; hits &= hits - 1) stack[size++] = node.child[__builtin_ctz(hits)];
  }
  return false;
}

}  // namespace verisim::accel
