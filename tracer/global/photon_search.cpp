#include "tracer/global/photon_search.h"

#include <algorithm>
#include <limits>

namespace verisim::global {

void PhotonPositions::resize(std::size_t n) {
  for (std::vector<float>* v : {&x, &y, &z}) v->assign(n + 3, 0.0f);
}

LatticeCube::LatticeCube(const Vec3& p, double side, bool& valid) {
  valid = side > 1e-30 && side < 1e30;
  if (!valid) return;
  level = std::ilogb(side);
  const double inverse = std::ldexp(1.0, -level);
  valid = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) * inverse < 1e15;
  if (!valid) return;
  const auto index = [inverse](double v) { return static_cast<std::int64_t>(std::floor(v * inverse)); };
  x = index(p.x), y = index(p.y), z = index(p.z);
}

std::uint64_t LatticeCube::hash() const {
  const auto mixed = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u + static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4Fu +
                     static_cast<std::uint64_t>(z) * 0x165667B19E3779F9u + static_cast<std::uint64_t>(level) * 0xD6E8FEB86659FD93u;
  return (mixed ^ mixed >> 32) * 0x9E3779B97F4A7C15u >> 40;
}

Vec3 LatticeCube::center() const {
  return {(static_cast<double>(x) + 0.5) * side(), (static_cast<double>(y) + 0.5) * side(), (static_cast<double>(z) + 0.5) * side()};
}

double& PhotonNeighbourhoods::guess(const Vec3& p, double radius) {
  constexpr double kSide = 0.35;  // of the radius
  bool valid;
  const LatticeCube cube(p, kSide * radius, valid);
  if (!valid) return no_guess_ = 0;
  if (guesses_.empty()) guesses_.resize(kGuesses);
  return guesses_[cube.hash() % kGuesses];
}

std::array<PhotonTree::Range, 2> PhotonTree::halves(const Range& r) {
  const std::uint32_t last = r.end - 1 - r.extra, middle = (r.first + last) / 2;
  return {{{r.first, middle + 1, 1}, {middle + 1, r.end, r.extra}}};
}

void PhotonTree::build_nodes(std::size_t count) {
  nodes_.clear();
  if (count > 0) add_node({0, static_cast<std::uint32_t>(count), 0});
}

void PhotonTree::set_bounds(Node& node, std::size_t lane, const Range& r) const {
  const std::array<const std::vector<float>*, 3> axes{&positions_.x, &positions_.y, &positions_.z};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto [low, high] = std::minmax_element(axes[a]->begin() + r.first, axes[a]->begin() + r.end);
    node.low[a][lane] = *low, node.high[a][lane] = *high;
  }
}

std::uint32_t PhotonTree::add_node(const Range& range) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node& fresh = nodes_.emplace_back();
  for (std::size_t a = 0; a < 3; ++a) {
    fresh.low[a].fill(std::numeric_limits<float>::infinity());
    fresh.high[a].fill(-std::numeric_limits<float>::infinity());
  }
  std::array<Range, 4> parts;
  std::size_t n = 0;
  if (range.size() <= kLeaf) {
    parts[n++] = range;
  } else {
    for (const Range& half : halves(range)) {
      if (half.size() <= kLeaf) {
        parts[n++] = half;
      } else {
        for (const Range& quarter : halves(half)) parts[n++] = quarter;
      }
    }
  }
  for (std::size_t lane = 0; lane < n; ++lane) {
    set_bounds(nodes_[number], lane, parts[lane]);
    const bool leaf = parts[lane].size() <= kLeaf;
    const std::uint32_t first = leaf ? parts[lane].first : add_node(parts[lane]);  // may move the nodes
    nodes_[number].first[lane] = first;
    nodes_[number].count[lane] = leaf ? parts[lane].size() : 0;
  }
  return number;
}

}  // namespace verisim::global
