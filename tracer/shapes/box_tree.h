// A bounding volume hierarchy with four children per node over any primitives that have boxes: triangles of meshes and patches, pieces of glyphs.
//
// Single precision finds, double precision decides: boxes are floats, grown so that no primitive is missed for any ray (see `padding`); what is in a
// leaf is tested by the caller in double.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "tracer/math/vec.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace verisim::shapes {

class BoxTree {
 public:
  static constexpr std::uint32_t kMaxLeaf = 8;

  BoxTree() = default;
  // box(i) gives the bounds of primitive i < count; primitives with an empty or non-finite box are left out.
  template <class F>
  BoxTree(std::size_t count, F&& box, std::uint32_t leaf_size = 4) {
    std::vector<Item> items;
    items.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Box3 b = box(i);
      if (!usable(b)) continue;
      bounds_.extendBy(b);
      Item& item = items.emplace_back();
      for (int k = 0; k < 3; ++k) item.lower[k] = static_cast<float>(b.min[k]), item.upper[k] = static_cast<float>(b.max[k]);
      item.id = static_cast<std::uint32_t>(i);
    }
    build(items, leaf_size);
  }

  // Primitives in the order of the leaves.
  const std::vector<std::uint32_t>& order() const { return order_; }
  const Box3& bounds() const { return bounds_; }
  bool empty() const { return order_.empty(); }

  // Calls leaf(first, count) for ranges of order() whose boxes the ray may meet in [t_min, t_max()], roughly from near to far. `t_max` is read again
  // after every leaf.
  template <class TMax, class Leaf>
  void traverse(const Vec3& origin, const Vec3& direction, double t_min, TMax&& t_max, Leaf&& leaf) const;

 private:
  // Embree's build primitive; rounding to float is covered by the padding.
  struct alignas(32) Item {
    float lower[3];
    std::uint32_t group = 0;
    float upper[3];
    std::uint32_t id;
  };
  struct alignas(16) Node {
    float bounds[6][4];  // lower x, upper x, lower y, ... of the children
    std::uint32_t child[4];
  };
  static constexpr std::uint32_t kLeaf = 0x80000000u, kFirstMask = 0x0fffffffu;
  static bool usable(const Box3& b) {
    for (int k = 0; k < 3; ++k) {
      if (!(b.min[k] <= b.max[k]) || !(std::fabs(b.min[k]) < 1e18) || !(std::fabs(b.max[k]) < 1e18)) return false;
    }
    return true;
  }
  void build(std::vector<Item>& items, std::uint32_t leaf_size);

  friend struct BoxTreeBuilder;
  std::vector<Node> nodes_;  // the root is nodes_[0]
  std::vector<std::uint32_t> order_;
  Box3 bounds_;              // padded
};

template <class TMax, class Leaf>
void BoxTree::traverse(const Vec3& origin, const Vec3& direction, double t_min, TMax&& t_max, Leaf&& leaf) const {
  if (nodes_.empty()) return;
  // In double: does the ray meet the whole, and where? The float ray starts there, so that its rounding errors are small against the tree.
  double enter = t_min, leave = t_max();
  for (int k = 0; k < 3; ++k) {
    if (direction[k] == 0) {
      if (origin[k] < bounds_.min[k] || origin[k] > bounds_.max[k]) return;
      continue;
    }
    const double r = 1 / direction[k];
    const double a = (bounds_.min[k] - origin[k]) * r, b = (bounds_.max[k] - origin[k]) * r;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (!(enter <= leave * (1 + 1e-12))) return;
  const Vec3 start = origin + enter * direction;
  if (!std::isfinite(dot(start, start) + dot(direction, direction))) return;
  const auto far_limit = [&] {
    const double t = t_max() - enter;
    return t < 1e30 ? static_cast<float>(t) * (t > 0 ? 1.000001f : 0.999999f) + 1e-30f : std::numeric_limits<float>::max();
  };

  float o[3], r[3];
  int near_plane[3];
  for (int k = 0; k < 3; ++k) {
    o[k] = static_cast<float>(start[k]);
    const double d = direction[k];
    r[k] = static_cast<float>(std::fabs(d) > 1e-18 ? 1 / d : std::copysign(1e18, d));
    near_plane[k] = 2 * k + (r[k] < 0 ? 1 : 0);
  }

  struct Entry {
    std::uint32_t child;
    float t;
  };
  Entry stack[3 * 64 + 4];
  int top = 0;
  stack[top++] = {0, 0};
  float limit = far_limit();
#if defined(__SSE2__)
  const __m128 ox = _mm_set1_ps(o[0]), oy = _mm_set1_ps(o[1]), oz = _mm_set1_ps(o[2]);
  const __m128 rx = _mm_set1_ps(r[0]), ry = _mm_set1_ps(r[1]), rz = _mm_set1_ps(r[2]);
#endif
  while (top > 0) {
    Entry entry = stack[--top];
    if (entry.t > limit) continue;
    while (!(entry.child & kLeaf)) {
      const Node& node = nodes_[entry.child];
      alignas(16) float near_t[4];
      unsigned hits = 0;
#if defined(__SSE2__)
      const auto plane = [&](int p, const __m128& org, const __m128& rdir) { return _mm_mul_ps(_mm_sub_ps(_mm_load_ps(node.bounds[p]), org), rdir); };
      const __m128 nx = plane(near_plane[0], ox, rx), ny = plane(near_plane[1], oy, ry), nz = plane(near_plane[2], oz, rz);
      const __m128 fx = plane(near_plane[0] ^ 1, ox, rx), fy = plane(near_plane[1] ^ 1, oy, ry), fz = plane(near_plane[2] ^ 1, oz, rz);
      const __m128 tn = _mm_max_ps(_mm_max_ps(nx, ny), _mm_max_ps(nz, _mm_setzero_ps()));
      const __m128 tf = _mm_min_ps(_mm_min_ps(fx, fy), _mm_min_ps(fz, _mm_set1_ps(limit)));
      _mm_store_ps(near_t, tn);
      hits = static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(tn, tf)));
#else
      for (unsigned i = 0; i < 4; ++i) {
        float tn = 0, tf = limit;
        for (int k = 0; k < 3; ++k) {
          tn = std::max(tn, (node.bounds[near_plane[k]][i] - o[k]) * r[k]);
          tf = std::min(tf, (node.bounds[near_plane[k] ^ 1][i] - o[k]) * r[k]);
        }
        near_t[i] = tn;
        hits |= (tn <= tf ? 1u : 0u) << i;
      }
#endif
      if (hits == 0) {
        entry.child = kLeaf;  // nothing here: take the next from the stack
        entry.t = -1;
        break;
      }
      // The nearest child next, the others on the stack, farthest first.
      const int begin = top;
      while (hits) {
        const auto i = static_cast<unsigned>(__builtin_ctz(hits));
        hits &= hits - 1;
        const Entry e{node.child[i], near_t[i]};
        int at = top++;
        for (; at > begin && stack[at - 1].t < e.t; --at) stack[at] = stack[at - 1];
        stack[at] = e;
      }
      entry = stack[--top];
    }
    if (entry.t < 0) continue;
    leaf(entry.child & kFirstMask, ((entry.child >> 28) & 7) + 1);
    limit = far_limit();
  }
}

}  // namespace verisim::shapes
