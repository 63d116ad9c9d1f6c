// Finds the irradiance samples that reach a point: an octree whose leaves list, side by side, all samples that may be
// found from somewhere within them.
//
// Leaves are about as wide as the samples in them reach, so that most of what a query reads is near enough. Floats sort
// out eight samples at a time (irradiance_packet.h); whoever asks decides in double. Samples come in the order in which
// they were added.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "tracer/radiosity/irradiance_packet.h"

namespace verisim::global {

class IrradianceTree {
 public:
  struct Entry {
    Vec3 point, normal;
    float mean_distance, widest;  // what distances are measured by, and what at most
    double radius;                // of the ball that it reaches at most
    Box3 within;                  // it is not found from outside of this box
    double extent() const {
      return 0.5 * std::max({within.max.x - within.min.x, within.max.y - within.min.y, within.max.z - within.min.z});
    }
  };
  // Files the sample of this number. What the tree must know of those it has already it asks for again, rarely, instead
  // of keeping it.
  using Entries = std::function<Entry(std::uint32_t sample)>;
  void add(std::uint32_t sample, const Entries& entries);
  // Calls visit(sample) for all whose distance r from x is below bound * mean_distance, and r / widest + 2 sqrt(1 -
  // cosine of the normals) below bound, and for some more.
  template <class Visit>
  void visit(const Vec3& x, double bound, const Vec3& normal, Visit&& visit) const;
  std::size_t bytes() const {
    return leaves_.size() * sizeof(Leaf) + branches_.size() * sizeof(Branch) + packets_ * sizeof(IrradiancePacket);
  }

 private:
  // A leaf or a branch. Branches are numbers and nothing else: a query's way down stays in the cache, and finds by
  // itself which cube it is in.
  struct Node {
    std::uint32_t number : 31 = 0, leaf : 1 = 0;
  };
  using Branch = std::array<Node, 8>;
  struct Cube {
    Vec3 center;
    double half;  // of the side
    double reach() const { return std::max({std::fabs(center.x), std::fabs(center.y), std::fabs(center.z)}) + half; }
    std::uint32_t octant(const Vec3& p) const {
      return (p.x >= center.x ? 1u : 0u) | (p.y >= center.y ? 2u : 0u) | (p.z >= center.z ? 4u : 0u);
    }
    Cube child(std::uint32_t octant) const {
      const double h = 0.5 * half;
      return {center + Vec3(octant & 1 ? h : -h, octant & 2 ? h : -h, octant & 4 ? h : -h), h};
    }
  };
  struct Leaf {
    std::vector<IrradiancePacket> packets;
    std::uint32_t count = 0;  // of its samples
    double unit = 0;          // of their points
    double extents = 0;       // their sum
  };
  static constexpr std::uint32_t kSmall = 32;  // samples of a leaf that need not be split
  static constexpr std::size_t kPackets = 32;  // that are asked at a time

  static bool contains(const Cube& cube, const Box3& box);
  static bool meets(const Cube& cube, const Entry& entry);
  // Octants of a cube that surely do not meet the entry, as bits.
  static std::uint32_t beside(const Cube& cube, const Entry& entry);
  Node add_leaf();
  void grow(const Entry& entry);
  void insert(Node& node, const Cube& cube, std::uint32_t sample, const Entry& entry, const Entries& entries);
  void append(Leaf& leaf, const Cube& cube, std::uint32_t sample, const Entry& entry);
  Node split(Node leaf, const Cube& cube, const Entries& entries);

  bool empty_ = true;
  Node root_;
  Cube root_cube_{};
  std::vector<Branch> branches_;
  std::vector<Leaf> leaves_;
  std::size_t packets_ = 0;
};

template <class Visit>
void IrradianceTree::visit(const Vec3& x, double bound, const Vec3& normal, Visit&& visit) const {
  static const IrradianceKernels& kernels = irradiance_kernels();
  if (empty_) return;
  const Vec3 outside = x - root_cube_.center;
  if (!(std::max({std::fabs(outside.x), std::fabs(outside.y), std::fabs(outside.z)}) <= root_cube_.half * (1.0 + 1e-9)))
    return;
  Node node = root_;
  Cube cube = root_cube_;
  while (!node.leaf) {
    const std::uint32_t octant = cube.octant(x);
    node = branches_[node.number][octant], cube = cube.child(octant);
  }
  const Leaf& leaf = leaves_[node.number];
  const IrradianceQuery query{x - cube.center, normal, bound, leaf.unit};
  constexpr std::size_t kSamples = kPackets * IrradiancePacket::kCount;
  for (std::size_t first = 0; first < leaf.count; first += kSamples) {
    std::uint32_t samples[kSamples];
    const IrradiancePacket* const packets = leaf.packets.data() + first / IrradiancePacket::kCount;
    const std::size_t found = kernels.near(packets, std::min(kSamples, leaf.count - first), query, samples);
    for (std::size_t i = 0; i < found; ++i) visit(samples[i]);
  }
}

}  // namespace verisim::global
