#include "tracer/photons/photon_tree.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace verisim::global {
namespace {

constexpr int kLevelsOfNode = std::bit_width(PhotonTree::kParts) - 1;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

void set_bounds(PhotonBoxes& boxes, std::size_t lane, std::span<const PhotonPosition> photons) {
  PhotonPosition low = photons.front(), high = low;
  for (const PhotonPosition& p : photons)
    for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
  for (std::size_t a = 0; a < 3; ++a) boxes.low[a][lane] = low[a], boxes.high[a][lane] = high[a];
}

// Around all that a node holds.
void set_bounds(PhotonBoxes& boxes, std::size_t lane, const PhotonBoxes& parts) {
  for (std::size_t a = 0; a < 3; ++a) {
    boxes.low[a][lane] = *std::ranges::min_element(parts.low[a]);
    boxes.high[a][lane] = *std::ranges::max_element(parts.high[a]);
  }
}

}  // namespace

void PhotonTree::build(std::span<const PhotonPosition> sorted) {
  nodes_.clear(), firsts_.clear();
  if (sorted.empty()) return;
  // Only the root may have few parts: nodes above the leaves are the many ones.
  const auto count = static_cast<std::uint32_t>(sorted.size());
  int levels = 0;
  while ((count >> levels) + 1 > kLeaf) ++levels;
  height_ = levels > 0 ? (levels - 1) / kLevelsOfNode : 0;
  const std::size_t leaves = std::size_t{1} << levels, lowest = leaves / kParts + 1;
  firsts_.reserve(leaves + 1);
  nodes_.reserve(lowest + lowest / kParts * 2 + 2);
  add_node(sorted, {0, count, 0}, height_, levels - height_ * kLevelsOfNode);
  firsts_.push_back(count);
}

// Halves the range and its parts `levels` times: none gets smaller than half a leaf.
std::uint32_t PhotonTree::add_node(std::span<const PhotonPosition> sorted, const Range& range, int height, int levels) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node& fresh = nodes_.emplace_back();
  for (std::size_t a = 0; a < 3; ++a) {
    fresh.boxes.low[a].fill(kInfinity);
    fresh.boxes.high[a].fill(-kInfinity);
  }
  std::array<Range, kParts> parts{range};
  std::size_t n = 1;
  for (int level = 0; level < levels; ++level) {
    std::array<Range, kParts> halves;
    std::size_t m = 0;
    for (const Range& r : std::span(parts.data(), n)) {
      const std::uint32_t last = r.end - 1 - r.extra, middle = (r.first + last) / 2;
      halves[m++] = {r.first, middle + 1, 1}, halves[m++] = {middle + 1, r.end, r.extra};
    }
    parts = halves, n = m;
  }
  for (std::size_t lane = 0; lane < n; ++lane) {
    const Range& part = parts[lane];
    if (height == 0) {
      set_bounds(nodes_[number].boxes, lane, sorted.subspan(part.first, part.size()));
      nodes_[number].child[lane] = static_cast<std::uint32_t>(firsts_.size());
      firsts_.push_back(part.first);
    } else {
      const std::uint32_t child = add_node(sorted, part, height - 1, kLevelsOfNode);  // may move the nodes
      nodes_[number].child[lane] = child;
      set_bounds(nodes_[number].boxes, lane, nodes_[child].boxes);
    }
  }
  return number;
}

}  // namespace verisim::global
