// A bounding volume hierarchy over boxes, four to a node: finds the candidates of a ray in single precision,
// conservatively, so that double precision can decide. Objects of a scene, triangles of a mesh, components of a blob
// are all found with it.
//
// A walk must not lose a candidate: boxes are stored in binary32 relative to the centre of all of them and widened by
// more than the rounding of any ray inside that volume, and rays are moved to where they enter it before they are
// rounded. Visitors (a shape's own intersection test) are inlined into the walk.
//
// Rays of a common shaft (shaft.h) may start at the few subtrees that the shaft meets instead of at the root: Reshetov,
// Soupikov and Hurley, "Multi-level ray tracing algorithm", 2005.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "tracer/bvh/box_node.h"
#include "tracer/bvh/boxes_along.h"
#include "tracer/bvh/bvh_builder.h"
#include "tracer/math/vec.h"
#include "tracer/base/parallel.h"

namespace verisim::accel {

class Shaft;

// The distances at which a ray enters and leaves a box; false if it misses it within t_min .. t_max, which are
// narrowed.
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
  return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y && p.z >= box.min.z &&
         p.z <= box.max.z;
}
inline bool is_finite(const Box3& box) {
  for (int i = 0; i < 3; ++i)
    if (!(std::fabs(box.min[i]) < 1e30 && std::fabs(box.max[i]) < 1e30)) return false;
  return true;
}
inline bool is_empty(const Box3& box) {
  return !(box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z);
}

class Bvh {
 public:
  Bvh() = default;
  // Empty and unbounded boxes are not allowed; index i of `boxes` is what the visitors get.
  explicit Bvh(std::span<const Box3> boxes);
  // box(i) gives the bounds of primitive i < count, the same at every call; those with an empty or unbounded box are
  // left out. Leaves hold up to `leaf_size` primitives, as ranges of order(); leaf_size 1: leaves name their primitive.
  template <class BoxOf>
  Bvh(std::size_t count, BoxOf&& box, unsigned leaf_size);

  bool empty() const { return nodes_.empty(); }
  const Box3& bounds() const { return bounds_; }
  // What the boxes of entries are relative to.
  const Vec3& center() const { return center_; }
  // What boxes are widened by.
  double slack() const { return slack_; }
  const std::vector<std::uint32_t>& order() const { return order_; }
  // What a node names a child by; node 0 is the root.
  const BoxNode& node(std::uint32_t i) const { return nodes_[i]; }

  // Calls visit(index, t_max) for every box that the ray meets between t_min and t_max, roughly in order of distance;
  // it returns the new t_max (the same, a smaller one, or minus infinity to stop). For trees of leaf size 1. `entry`:
  // of a shaft that holds the ray; null: the root.
  template <class Visit>
  void traverse(const Ray& ray, double t_min, double t_max, Visit&& visit, const EntryPoints* entry = nullptr) const {
    walk(ray, t_min, t_max, entry,
         [&](std::uint32_t leaf, double far) { return visit(BoxNode::leaf_first(leaf), far); });
  }
  // The same with visit(first, count, t_max) for ranges of order().
  template <class Visit>
  void traverse_leaves(const Ray& ray, double t_min, double t_max, Visit&& visit,
                       const EntryPoints* entry = nullptr) const {
    walk(ray, t_min, t_max, entry, [&](std::uint32_t leaf, double far) {
      return visit(BoxNode::leaf_first(leaf), BoxNode::leaf_count(leaf), far);
    });
  }
  // All boxes that the ray meets between t_min and t_max; false: they are too many. For trees of leaf size 1.
  bool boxes_along(const Ray& ray, double t_min, double t_max, const EntryPoints* entry, BoxesAlong& met) const;
  // Calls visit(index) for every box that contains p (and perhaps some that narrowly do not) until it returns true.
  // Returns whether one did. For trees of leaf size 1.
  template <class Visit>
  bool any_around(const Vec3& p, Visit&& visit) const;

  // The subtrees that a shaft meets.
  void enter(const Shaft& shaft, EntryPoints& entry) const;

  static constexpr int kStackSize = 256;  // of a walk

 private:
  static bool usable(const Box3& box) { return !is_empty(box) && is_finite(box); }
  void set_bounds(const Box3& bounds);
  BuildItem item_of(const Box3& box, std::size_t index) const;
  void build(std::vector<BuildItem>& items, unsigned leaf_size);
  // Where the ray enters and leaves the bounds between t_min and t_max. False: it does not.
  bool cross_bounds(const Ray& ray, const Vec3& inverse, double t_min, double t_max, double& start, double& end) const;
  template <class Leaf>
  void walk(const Ray& ray, double t_min, double t_max, const EntryPoints* entry, Leaf&& leaf) const;

  std::vector<BoxNode> nodes_;  // the first is the root
  std::vector<std::uint32_t> order_;
  Box3 bounds_;  // of all, widened
  Vec3 center_{0, 0, 0};
  double slack_ = 0;
};

template <class BoxOf>
Bvh::Bvh(std::size_t count, BoxOf&& box, unsigned leaf_size) {
  constexpr std::size_t kRun =
      65536;  // primitives that one task looks at; fixed, so that the tree is the same for any number of threads
  struct Run {
    Box3 bounds;
    std::size_t used = 0;
    std::vector<BuildItem> items;
  };
  std::vector<Run> runs((count + kRun - 1) / kRun);
  const auto each_box = [&](std::size_t r, auto use) {
    for (std::size_t i = r * kRun; i < std::min(count, (r + 1) * kRun); ++i)
      if (const Box3 b = box(i); usable(b)) use(i, b);
  };
  parallel_for(runs.size(), 1, [&](std::size_t r) {
    each_box(r, [&](std::size_t, const Box3& b) {
      runs[r].bounds.extendBy(b);
      ++runs[r].used;
    });
  });
  Box3 bounds;
  for (const Run& run : runs)
    if (run.used > 0) bounds.extendBy(run.bounds);
  if (is_empty(bounds)) return;
  set_bounds(bounds);
  parallel_for(runs.size(), 1, [&](std::size_t r) {
    std::vector<BuildItem>& items = runs[r].items;
    items.reserve(leaf_size > 1 ? runs[r].used / 2 + runs[r].used / 16 + 1 : runs[r].used);
    each_box(r, [&](std::size_t i, const Box3& b) {
      const BuildItem item = item_of(b, i);
      // Neighbours in the list that are neighbours in space, as in most meshes, stay together: half of the work.
      if (leaf_size > 1 && !items.empty() && merge_if_close(items.back(), item)) return;
      items.push_back(item);
    });
  });
  std::vector<BuildItem> items;
  if (runs.size() == 1) {
    items = std::move(runs[0].items);
  } else {
    std::size_t total = 0;
    for (const Run& run : runs) total += run.items.size();
    items.reserve(total);
    for (Run& run : runs) {
      items.insert(items.end(), run.items.begin(), run.items.end());
      run.items = {};
    }
  }
  build(items, leaf_size);
}

// Children that wait for their turn in a walk, the nearer ones on top.
class WaitingChildren {
 public:
  struct Child {
    std::uint32_t child;
    float near;
  };
  int size() const { return size_; }
  // Among those above `first`.
  void add(Child added, int first) {
    int place = size_++;
    for (; place > first && stack_[place - 1].near < added.near; --place) stack_[place] = stack_[place - 1];
    stack_[place] = added;
  }
  // The nearest; false: none is within a distance.
  bool pop(float far, Child& next) {
    while (size_ > 0) {
      next = stack_[--size_];
      if (next.near <= far) return true;
    }
    return false;
  }

 private:
  Child stack_[Bvh::kStackSize];
  int size_ = 0;
};

inline bool Bvh::cross_bounds(const Ray& ray, const Vec3& inverse, double t_min, double t_max, double& start,
                              double& end) const {
  start = t_min, end = t_max;
  for (int i = 0; i < 3; ++i) {
    // A zero direction makes infinities of the right signs, or NaN on the very face, which the comparisons ignore.
    double enter = (bounds_.min[i] - ray.origin[i]) * inverse[i], leave = (bounds_.max[i] - ray.origin[i]) * inverse[i];
    if (enter > leave) std::swap(enter, leave);
    if (enter > start) start = enter;
    if (leave < end) end = leave;
  }
  return start <= end;
}

template <class Leaf>
void Bvh::walk(const Ray& ray, double t_min, double t_max, const EntryPoints* entry, Leaf&& leaf) const {
  if (nodes_.empty() || (entry && entry->count == 0)) return;
  const Vec3 inverse(1.0 / ray.direction.x, 1.0 / ray.direction.y, 1.0 / ray.direction.z);
  double start, end;
  if (!cross_bounds(ray, inverse, t_min, t_max, start, end)) return;
  const Vec3 from = ray.origin - center_ + start * ray.direction;
  if (!(dot(from, from) < std::numeric_limits<double>::infinity()))
    return;  // no ray at all: its numbers would defeat the comparisons
  const NodeRay node_ray(from, inverse);
  // Distances in the walk count from `start`.
  float far = round_up(end - start + slack_);

  WaitingChildren waiting;
  WaitingChildren::Child next{0, 0};
  // The nearest of the children that are met becomes `next`; the others wait. False: none is met.
  const auto descend = [&](const BoxNode& node) {
    alignas(16) float near[4];
    unsigned hits = node_ray.test(node, far, near);
    if (hits == 0) return false;
    int k = __builtin_ctz(hits);
    next = {node.child[k], near[k]};
    const int first = waiting.size();
    while ((hits &= hits - 1) != 0) {
      k = __builtin_ctz(hits);
      WaitingChildren::Child other{node.child[k], near[k]};
      if (other.near < next.near) std::swap(other, next);
      waiting.add(other, first);
    }
    return true;
  };
  if (entry) {
    for (int i = 0; i < entry->count; ++i) {
      alignas(16) float near[4];
      const BoxNode& node = entry->nodes[i];
      for (unsigned hits = node_ray.test(node, far, near); hits != 0; hits &= hits - 1) {
        const int k = __builtin_ctz(hits);
        waiting.add({node.child[k], near[k]}, 0);
      }
    }
    if (!waiting.pop(far, next)) return;
  }
  for (;;) {
    if (next.child & BoxNode::kLeaf) {
      const double limit = leaf(next.child, t_max);
      if (limit < t_max) {
        t_max = limit;
        if (t_max < t_min) return;
        far = round_up(t_max - start + slack_);
      }
      if (!waiting.pop(far, next)) return;
    } else if (!descend(nodes_[next.child]) && !waiting.pop(far, next)) {
      return;
    }
  }
}

template <class Visit>
bool Bvh::any_around(const Vec3& p, Visit&& visit) const {
  if (nodes_.empty() || !contains(bounds_, p)) return false;
  const Vec3 q = p - center_;
  const float point[3] = {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
  std::uint32_t stack[kStackSize];
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t child = stack[--size];
    if (child & BoxNode::kLeaf) {
      if (visit(BoxNode::leaf_first(child))) return true;
      continue;
    }
    const BoxNode& node = nodes_[child];
    for (unsigned hits = boxes_around(node, point); hits != 0; hits &= hits - 1)
      stack[size++] = node.child[__builtin_ctz(hits)];
  }
  return false;
}

}  // namespace verisim::accel
