// Builds the nodes of a Bvh by the binned surface area heuristic (Wald, "On fast construction of SAH-based bounding
// volume hierarchies", 2007).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tracer/bvh/box_node.h"

namespace verisim::accel {

// A run of consecutive boxes that stay together: `count` from `first`, and the box around them.
struct alignas(16) BuildItem {
  float low[3];
  std::uint32_t first_bits;  // biased: corners are added up four lanes at a time, and small integers would be denormal
                             // floats, which are slow
  float high[3];
  std::uint32_t count_bits;

  static constexpr std::uint32_t kBias = 0x3f800000u;
  void set(std::uint32_t first, std::uint32_t count) { first_bits = first + kBias, count_bits = count + kBias; }
  std::uint32_t first() const { return first_bits - kBias; }
  std::uint32_t count() const { return count_bits - kBias; }
};

// Adds b to a if it continues a single box and both together are hardly larger than apart.
inline bool merge_if_close(BuildItem& a, const BuildItem& b) {
  if (a.count() != 1 || b.first() != a.first() + 1) return false;
  const auto area = [](const float* low, const float* high) {
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x * y + y * z + z * x;
  };
  float low[3], high[3];
  for (int i = 0; i < 3; ++i) low[i] = std::min(a.low[i], b.low[i]), high[i] = std::max(a.high[i], b.high[i]);
  if (!(area(low, high) < 0.8f * (area(a.low, a.high) + area(b.low, b.high)))) return false;
  std::copy_n(low, 3, a.low);
  std::copy_n(high, 3, a.high);
  a.set(a.first(), 2);
  return true;
}

struct BuiltTree {
  std::vector<BoxNode> nodes;  // the first is the root
  std::vector<std::uint32_t>
      order;  // the boxes as leaves refer to them; empty if leaf_size is 1: leaves name their box then
};

// The items are used up. At least one; no item counts more than leaf_size, which is at most BoxNode::kMaxLeaf. The tree
// is the same for any number of threads.
BuiltTree build_bvh(std::vector<BuildItem>& items, unsigned leaf_size);

}  // namespace verisim::accel
