#include "tracer/global/photon_search.h"

#include <algorithm>
#include <limits>
#include <span>

namespace verisim::global {

NearbyRadii::Known& NearbyRadii::at(const Vec3& p, double radius) {
  // A lattice with sides that are powers of two.
  const double side = 0.35 * radius;
  if (!(side > 1e-30 && side < 1e30)) return nowhere_ = {};
  const int level = std::ilogb(side);
  const double inverse = std::ldexp(1.0, -level);
  if (!(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) * inverse < 1e15)) return nowhere_ = {};
  const auto index = [inverse](double v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v * inverse))); };
  const std::uint64_t mixed = index(p.x) * 0x9E3779B97F4A7C15u + index(p.y) * 0xC2B2AE3D27D4EB4Fu + index(p.z) * 0x165667B19E3779F9u +
                              static_cast<std::uint64_t>(level) * 0xD6E8FEB86659FD93u;
  if (known_.empty()) known_.resize(kPlaces);
  return known_[((mixed ^ mixed >> 32) * 0x9E3779B97F4A7C15u >> 40) % kPlaces];
}

void PhotonTree::build_nodes(std::size_t count) {
  nodes_.clear();
  if (count > 0) add_node({0, static_cast<std::uint32_t>(count), 0});
}

void PhotonTree::set_bounds(PhotonBoxes& boxes, std::size_t lane, const Range& r) const {
  const std::array<const std::vector<float>*, 3> axes{&positions_.x, &positions_.y, &positions_.z};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto [low, high] = std::minmax_element(axes[a]->begin() + r.first, axes[a]->begin() + r.end);
    boxes.low[a][lane] = *low, boxes.high[a][lane] = *high;
  }
}

std::uint32_t PhotonTree::add_node(const Range& range) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node& fresh = nodes_.emplace_back();
  for (std::size_t a = 0; a < 3; ++a) {
    fresh.boxes.low[a].fill(std::numeric_limits<float>::infinity());
    fresh.boxes.high[a].fill(-std::numeric_limits<float>::infinity());
  }
  std::array<Range, kParts> parts{range};
  std::size_t n = 1;
  for (std::size_t step = 0; step < std::bit_width(kParts) - 1; ++step) {
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
    const std::uint32_t first = leaf ? parts[lane].first : add_node(parts[lane]);  // may move the nodes
    nodes_[number].first[lane] = first;
    nodes_[number].count[lane] = leaf ? parts[lane].size() : 0;
  }
  return number;
}

}  // namespace verisim::global
