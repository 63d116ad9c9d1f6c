// Finds the irradiance samples that reach a point: an octree whose leaves list, side by side, all samples that may be found from somewhere within them.
//
// Leaves are about as wide as the samples in them reach, so that most of what a query reads is near enough. Floats sort out four samples at a time, with
// margins for their rounding; whoever asks decides in double. Samples come in the order in which they were added.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tracer/accel/float4.h"
#include "tracer/math/vec.h"

namespace verisim::global {

class IrradianceTree {
 public:
  struct Entry {
    std::uint32_t sample;  // number, for whoever asks
    Vec3 point, normal;
    float mean_distance, widest;  // what distances are measured by, and what at most
    double radius;         // of the ball that it reaches at most
    Box3 within;           // it is not found from outside of this box
    double extent() const { return 0.5 * std::max({within.max.x - within.min.x, within.max.y - within.min.y, within.max.z - within.min.z}); }
  };
  void add(const Entry& entry);
  // Calls visit(sample) for all whose distance r from x is below bound * mean_distance, and r / widest + 2 sqrt(1 - cosine of the normals) below bound, and
  // for some more.
  template <class Visit>
  void visit(const Vec3& x, double bound, const Vec3& normal, Visit&& visit) const;
  std::size_t bytes() const { return entries_.size() * sizeof(Entry) + nodes_.size() * sizeof(Node) + lanes_ * sizeof(Lanes); }

 private:
  // Four samples; unused places are far from everywhere.
  struct alignas(16) Lanes {
    float point[3][4], normal[3][4];  // points relative to the node's centre
    float mean_distance[4], widest[4];
    std::uint32_t entry[4], sample[4];
  };
  struct Node {
    Vec3 center;
    double half;                  // of the side
    std::uint32_t children = 0;   // the first of eight; 0: a leaf
    std::uint32_t count = 0;      // of a leaf's samples
    double farthest = 0, extents = 0;  // of these: largest coordinate relative to the centre, sum of extents
    std::vector<Lanes> lanes;
    double reach() const { return std::max({std::fabs(center.x), std::fabs(center.y), std::fabs(center.z)}) + half; }
    std::uint32_t octant(const Vec3& p) const { return (p.x >= center.x ? 1u : 0u) | (p.y >= center.y ? 2u : 0u) | (p.z >= center.z ? 4u : 0u); }
  };
  static constexpr std::uint32_t kLeaf = 32;  // samples that need not be split

  static bool contains(const Node& node, const Box3& box);
  static bool meets(const Node& node, const Entry& entry);
  static Vec3 child_center(const Node& node, std::uint32_t octant);
  std::uint32_t add_children(const Vec3& center, double half);
  void grow(const Entry& entry);
  void insert(std::uint32_t node, std::uint32_t entry);
  void append(Node& leaf, std::uint32_t entry);
  void split(std::uint32_t node);

  std::vector<Node> nodes_;  // the first one is the root
  std::vector<Entry> entries_;
  std::size_t lanes_ = 0;
};

template <class Visit>
void IrradianceTree::visit(const Vec3& x, double bound, const Vec3& normal, Visit&& visit) const {
  using accel::Float4;
  constexpr double kMargin = 1e-5;
  if (nodes_.empty()) return;
  const Node* node = &nodes_.front();
  const Vec3 outside = x - node->center;
  if (!(std::max({std::fabs(outside.x), std::fabs(outside.y), std::fabs(outside.z)}) <= node->half * (1.0 + 1e-9))) return;
  while (node->children != 0) node = &nodes_[node->children + node->octant(x)];
  const auto all = [](double v) { return Float4(static_cast<float>(v)); };
  const Vec3 p = x - node->center;
  const Float4 px = all(p.x), py = all(p.y), pz = all(p.z), nx = all(normal.x), ny = all(normal.y), nz = all(normal.z);
  const Float4 most = all(bound * (1.0 + kMargin)), rounding = all(2e-6 * (node->farthest + node->half)), none = all(0.0), one = all(1.0 - kMargin), two = all(2.0);
  for (const Lanes& s : node->lanes) {
    const auto load = [](const float* v) { return Float4::load(v); };
    const Float4 dx = load(s.point[0]) - px, dy = load(s.point[1]) - py, dz = load(s.point[2]) - pz;
    const Float4 reach = load(s.mean_distance) * most + rounding;
    const Float4 cosine = load(s.normal[0]) * nx + load(s.normal[1]) * ny + load(s.normal[2]) * nz;
    const Float4 left = most - two * sqrt(max(one - cosine, none)), widest = max(load(s.widest) * left, none) + rounding;
    const Float4 squared = dx * dx + dy * dy + dz * dz;
    for (unsigned bits = ((squared <= reach * reach) & (squared <= widest * widest) & (none <= left)).bits(); bits != 0; bits &= bits - 1)
      visit(s.sample[std::countr_zero(bits)]);
  }
}

}  // namespace verisim::global
