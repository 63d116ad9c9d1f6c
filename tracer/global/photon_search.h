// Candidates for the photons nearest to a point: a tree of boxes, in floats with margins for their rounding; leaves are left to the kernels.
//
// Candidates come in the order of the map.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tracer/global/photon_kernels.h"
#include "tracer/math/vec.h"

namespace verisim::global {

// All photons of a map.
class PhotonTree {
 public:
  // `position(i)` is a std::array<float, 3>; photon (first + last) / 2 of a range [first, last] is the median of one coordinate, and so on within.
  template <class Position>
  void build(std::size_t count, Position&& position) {
    positions_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::array<float, 3>& p = position(i);
      positions_.x[i] = p[0], positions_.y[i] = p[1], positions_.z[i] = p[2];
    }
    build_nodes(count);
  }
  const PhotonPositions& positions() const { return positions_; }
  // Calls visit(first, count) for ranges of at most kLeaf photons, with all whose squared distance from p is below `limit` in them. visit may lower the limit.
  template <class Visit>
  void visit(const Vec3& p, const double& limit, Visit&& visit) const;

 private:
  static constexpr std::uint32_t kLeaf = PhotonPositions::kAtOnce, kParts = PhotonPositions::kAtOnce;
  struct Node {
    PhotonBoxes boxes;
    std::array<std::uint32_t, kParts> first, count;  // photons of a leaf, or, with count 0, a node's number
  };
  // Photons [first, end), sorted like the map except for the last `extra` ones, which are medians of larger ranges.
  struct Range {
    std::uint32_t first, end, extra;
    std::uint32_t size() const { return end - first; }
  };
  // A search: a point in floats, and how far from it a float may say a box is with a photon whose squared distance is below the limit.
  struct Near {
    Near(const Vec3& p, const double& search_limit)
        : point{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
          error(4e-7 * (std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z))), limit(search_limit) { update(); }
    void update() {
      if (limit == known) return;
      known = limit;
      const double r = std::sqrt(limit) + error;
      reach = static_cast<float>(std::min(r * r * (1.0 + 1e-5), 1e38));
    }
    std::array<float, 3> point;
    double error;
    const double& limit;
    double known = -1;
    float reach = 0;
  };
  void build_nodes(std::size_t count);
  std::uint32_t add_node(const Range& range);
  void set_bounds(PhotonBoxes& boxes, std::size_t lane, const Range& range) const;
  template <class Visit>
  void visit(const Node& node, Near& near, Visit&& visit) const;

  const PhotonKernels& kernels_ = photon_kernels();
  PhotonPositions positions_;
  std::vector<Node> nodes_;
};

// What one thread remembers of searches in one map. Points that are searched from lie close together when a picture is fine, or where a ray goes through
// media: the radius that was enough nearby is enough here, if it is as much larger as the point is farther away.
class NearbyRadii {
 public:
  struct Known {
    Vec3 point{0.0};
    double radius = 0;  // 0: nothing known
    // More than that are to be looked at again if it is too little, which is cheaper than to be sure.
    double enough(const Vec3& p) const { return radius > 0.0 ? std::min(radius * (1.0 + 1e-9) + length(p - point), 1.1 * radius) : 0.0; }
  };
  // The last search near p, for searches within `radius`; what is written is remembered.
  Known& at(const Vec3& p, double radius);

 private:
  static constexpr std::size_t kPlaces = 4096;
  std::vector<Known> known_;
  Known nowhere_;
};

template <class Visit>
void PhotonTree::visit(const Vec3& p, const double& limit, Visit&& leaf) const {
  Near near(p, limit);
  if (!nodes_.empty()) visit(nodes_.front(), near, leaf);
}

template <class Visit>
void PhotonTree::visit(const Node& node, Near& near, Visit&& leaf) const {
  for (unsigned bits = kernels_.boxes(node.boxes, near.point, near.reach); bits != 0; bits &= bits - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(bits));
    if (node.count[i] > 0) {
      leaf(node.first[i], node.count[i]);
    } else {
      near.update();
      visit(nodes_[node.first[i]], near, leaf);
    }
  }
}

}  // namespace verisim::global
