// Candidates for the photons nearest to a point: a tree of boxes, in floats with margins for their rounding; ranges of
// at most sixteen photons, the leaves, are left to the kernels. All leaves are equally deep, so that a walk need not
// ask what a part is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tracer/photons/photon.h"
#include "tracer/photons/photon_kernels.h"

namespace verisim::global {

class PhotonTree {
 public:
  static constexpr std::uint32_t kLeaf = kPhotonsAtOnce, kParts = kPhotonsAtOnce;
  struct Node {
    PhotonBoxes boxes;
    std::array<std::uint32_t, kParts> child;  // nodes; those of the lowest nodes are leaves
  };

  // Photon (first + last) / 2 of a range [first, last] is the median of one coordinate, and so on within.
  void build(std::span<const PhotonPosition> sorted);
  // The numbers of the leaves' first photons, and that of the last one's end.
  std::span<const std::uint32_t> firsts() const { return firsts_; }
  // The first one is the root; there is none without photons. Parts of a node are in the order of the map.
  std::span<const Node> nodes() const { return nodes_; }
  // How many levels of nodes are below the root.
  int height() const { return height_; }

 private:
  // Photons [first, end), sorted like the map except for the last `extra` ones, which are medians of larger ranges.
  struct Range {
    std::uint32_t first, end, extra;
    std::uint32_t size() const { return end - first; }
  };
  std::uint32_t add_node(std::span<const PhotonPosition> sorted, const Range& range, int height, int levels);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> firsts_;
  int height_ = 0;
};

}  // namespace verisim::global
