#include "tracer/global/photon_tree.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace verisim::global {
namespace {

constexpr int kLevelsOfNode = std::bit_width(PhotonTree::kParts) - 1;

}  // namespace

void PhotonTree::build(std::span<const Photon> sorted) {
  nodes_.clear();
  positions_.resize(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const std::array<float, 3>& p = sorted[i].position;
    positions_.x[i] = p[0], positions_.y[i] = p[1], positions_.z[i] = p[2];
  }
  if (sorted.empty()) return;
  // Only the root may have few parts: nodes above the leaves are the many ones.
  const auto count = static_cast<std::uint32_t>(sorted.size());
  int levels = 0;
  while ((count >> levels) + 1 > kLeaf) ++levels;
  add_node({0, count, 0}, levels > 0 ? (levels - 1) % kLevelsOfNode + 1 : 0);
}

void PhotonTree::set_bounds(PhotonBoxes& boxes, std::size_t lane, const Range& r) const {
  const std::array<const std::vector<float>*, 3> axes{&positions_.x, &positions_.y, &positions_.z};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto [low, high] = std::minmax_element(axes[a]->begin() + r.first, axes[a]->begin() + r.end);
    boxes.low[a][lane] = *low, boxes.high[a][lane] = *high;
  }
}

// Halves the range and its parts `levels` times.
std::uint32_t PhotonTree::add_node(const Range& range, int levels) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node& fresh = nodes_.emplace_back();
  for (std::size_t a = 0; a < 3; ++a) {
    fresh.boxes.low[a].fill(std::numeric_limits<float>::infinity());
    fresh.boxes.high[a].fill(-std::numeric_limits<float>::infinity());
  }
  std::array<Range, kParts> parts{range};
  std::size_t n = 1;
  for (int level = 0; level < levels; ++level) {
    std::array<Range, kParts> halves;
    std::size_t m = 0;
    for (const Range& r : std::span(parts.data(), n)) {
      const std::uint32_t last = r.end - 1 - r.extra, middle = (r.first + last) / 2;
      if (r.size() <= kLeaf) {
        halves[m++] = r;
      } else {
        halves[m++] = {r.first, middle + 1, 1}, halves[m++] = {middle + 1, r.end, r.extra};
      }
    }
    parts = halves, n = m;
  }
  for (std::size_t lane = 0; lane < n; ++lane) {
    set_bounds(nodes_[number].boxes, lane, parts[lane]);
    const bool leaf = parts[lane].size() <= kLeaf;
    const std::uint32_t first = leaf ? parts[lane].first : add_node(parts[lane], kLevelsOfNode);  // may move the nodes
    nodes_[number].first[lane] = first;
    nodes_[number].count[lane] = leaf ? parts[lane].size() : 0;
  }
  return number;
}

}  // namespace verisim::global
