// Four boxes tested at once: the node of a Bvh, and what is tested against it.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "tracer/simd/float4.h"
#include "tracer/math/vec.h"

namespace verisim::accel {

struct alignas(64) BoxNode {
  // The child is a leaf: kLeaf, then three bits for the number of its boxes less one, then the first of them.
  static constexpr std::uint32_t kLeaf = 0x80000000u, kFirstMask = 0x0fffffffu, kMaxLeaf = 8;
  static constexpr int kCountShift = 28;
  static std::uint32_t leaf(std::uint32_t first, std::uint32_t count) {
    return kLeaf | (count - 1) << kCountShift | first;
  }
  static std::uint32_t leaf_first(std::uint32_t child) { return child & kFirstMask; }
  static std::uint32_t leaf_count(std::uint32_t child) { return ((child >> kCountShift) & 7) + 1; }

  // Bounds of the children by axis; the boxes of missing children are empty.
  float planes[6][4];      // low x, y, z; high x, y, z
  std::uint32_t child[4];  // a node or a leaf

  void clear() {
    for (int k = 0; k < 4; ++k) {
      child[k] = 0;
      // A box that nothing meets, without infinities: those would make NaN.
      for (int i = 0; i < 6; ++i) planes[i][k] = i < 3 ? 3e37f : -3e37f;
    }
  }
};

inline float round_down(double v) {
  const float f = static_cast<float>(v);
  return f <= v ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}
// An upper limit for comparisons with binary32 distances: generous by a few roundings, cheap.
inline float round_up(double v) {
  const float f = static_cast<float>(v);
  return f + std::fabs(f) * 3e-7f;
}

// A ray in the single precision of the nodes.
class NodeRay {
 public:
  // `inverse`: 1 / direction; infinities are replaced, because 0 * infinity would turn into NaN, and what is zero in
  // single precision, because it would take all planes, those of missing children too, to the same place.
  NodeRay(const Vec3& origin, const Vec3& inverse) {
    constexpr float kLeast = std::numeric_limits<float>::min();
    for (int i = 0; i < 3; ++i) {
      float r = static_cast<float>(inverse[i]);
      if (!(std::fabs(r) < 1e30f)) r = std::copysign(1e30f, r);
      if (std::fabs(r) < kLeast) r = std::copysign(kLeast, r);
      const bool backward = r < 0;
      front_[i] = backward ? 12 + 4 * i : 4 * i;
      back_[i] = backward ? 4 * i : 12 + 4 * i;
      origin_[i] = Float4(static_cast<float>(origin[i]));
      inverse_[i] = Float4(r);
    }
  }

  // Bit k: child k is met between 0 and `far`; near[k]: where it is entered. `near` is aligned to 16 bytes.
  unsigned test(const BoxNode& node, float far, float near[4]) const {
    const Range met = cross(node, far);
    met.enter.store(near);
    return (met.enter <= met.leave).bits();
  }
  // The same; leave[k]: where it is left, or `far`.
  unsigned test(const BoxNode& node, float far, float near[4], float leave[4]) const {
    const Range met = cross(node, far);
    met.enter.store(near);
    met.leave.store(leave);
    return (met.enter <= met.leave).bits();
  }

 private:
  struct Range {
    Float4 enter, leave;
  };
  Range cross(const BoxNode& node, float far) const {
    const float* planes = node.planes[0];
    const auto plane = [&](int offset, int i) { return (Float4::load(planes + offset) - origin_[i]) * inverse_[i]; };
    return {max(max(plane(front_[0], 0), plane(front_[1], 1)), max(plane(front_[2], 2), Float4(0))),
            min(min(plane(back_[0], 0), plane(back_[1], 1)), min(plane(back_[2], 2), Float4(far)))};
  }

  Float4 origin_[3], inverse_[3];
  int front_[3], back_[3];  // where the planes a ray meets first and last stand in a node, in floats
};

// Where the rays of a shaft start in a tree: the subtrees that it meets.
struct EntryPoints {
  static constexpr int kNodes = 4, kMax = 4 * kNodes;
  BoxNode nodes[kNodes];
  int count = 0;         // of nodes; 0: the shaft meets nothing
  bool complete = true;  // every entry is a leaf
};

// Bit k: child k contains the point.
inline unsigned boxes_around(const BoxNode& node, const float p[3]) {
  Mask4 inside = Float4(0) <= Float4(0);
  for (int i = 0; i < 3; ++i) {
    const Float4 v(p[i]);
    inside = inside & (Float4::load(node.planes[i]) <= v) & (v <= Float4::load(node.planes[3 + i]));
  }
  return inside.bits();
}

}  // namespace verisim::accel
