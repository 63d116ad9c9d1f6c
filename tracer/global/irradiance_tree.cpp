#include "tracer/global/irradiance_tree.h"

namespace verisim::global {

bool IrradianceTree::contains(const Node& node, const Box3& box) {
  for (int a = 0; a < 3; ++a) {
    if (!(box.min[a] >= node.center[a] - node.half && box.max[a] <= node.center[a] + node.half)) return false;
  }
  return true;
}

bool IrradianceTree::meets(const Node& node, const Entry& entry) {
  const double half = node.half + 1e-12 * node.reach();  // sides of neighbours may be apart by their rounding
  double squared = 0;
  for (int a = 0; a < 3; ++a) {
    const double low = node.center[a] - half, high = node.center[a] + half;
    if (entry.within.min[a] > high || entry.within.max[a] < low) return false;
    const double gap = std::max({0.0, low - entry.point[a], entry.point[a] - high});
    squared += gap * gap;
  }
  return squared <= entry.radius * entry.radius * (1.0 + 1e-9);
}

Vec3 IrradianceTree::child_center(const Node& node, std::uint32_t octant) {
  const double h = 0.5 * node.half;
  return node.center + Vec3(octant & 1 ? h : -h, octant & 2 ? h : -h, octant & 4 ? h : -h);
}

// Eight leaves that fill this cube.
std::uint32_t IrradianceTree::add_children(const Vec3& center, double half) {
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  Node parent;
  parent.center = center, parent.half = half;
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    Node& child = nodes_.emplace_back();
    child.center = child_center(parent, octant), child.half = 0.5 * half;
  }
  return first;
}

// Doubles the root until it holds all from where the entry is found.
void IrradianceTree::grow(const Entry& entry) {
  if (nodes_.empty()) {
    Node& root = nodes_.emplace_back();
    root.center = entry.point;
    root.half = std::max(entry.extent(), 1e-6 * root.reach());
  }
  while (!contains(nodes_.front(), entry.within)) {
    const Vec3 center = nodes_.front().center;
    const double half = nodes_.front().half;
    const Vec3 to = entry.point - center;
    const Vec3 wider(center.x + (to.x >= 0 ? half : -half), center.y + (to.y >= 0 ? half : -half), center.z + (to.z >= 0 ? half : -half));
    const std::uint32_t first = add_children(wider, 2.0 * half);
    Node& root = nodes_.front();
    Node old = std::move(root);
    root = Node();
    root.center = wider, root.half = 2.0 * half, root.children = first;
    nodes_[first + root.octant(center)] = std::move(old);
  }
}

void IrradianceTree::append(Node& leaf, std::uint32_t entry) {
  const Entry& e = entries_[entry];
  const std::uint32_t lane = leaf.count++ % 4;
  if (lane == 0) {
    std::fill_n(leaf.lanes.emplace_back().point[0], 4, 1e18f);
    ++lanes_;
  }
  Lanes& to = leaf.lanes.back();
  const Vec3 p = e.point - leaf.center;
  for (int a = 0; a < 3; ++a) to.point[a][lane] = static_cast<float>(p[a]), to.normal[a][lane] = static_cast<float>(e.normal[a]);
  to.mean_distance[lane] = e.mean_distance, to.widest[lane] = e.widest;
  to.entry[lane] = entry, to.sample[lane] = e.sample;
  leaf.farthest = std::max({leaf.farthest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  leaf.extents += e.extent();
}

void IrradianceTree::split(std::uint32_t node) {
  const std::uint32_t first = add_children(nodes_[node].center, nodes_[node].half);
  Node& parent = nodes_[node];
  const std::vector<Lanes> lanes = std::move(parent.lanes);
  const std::uint32_t count = parent.count;
  parent.lanes.clear();
  parent.children = first, parent.count = 0;
  lanes_ -= lanes.size();
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t entry = lanes[i / 4].entry[i % 4];
    for (std::uint32_t k = first; k < first + 8; ++k) {
      if (meets(nodes_[k], entries_[entry])) append(nodes_[k], entry);
    }
  }
}

void IrradianceTree::insert(std::uint32_t node, std::uint32_t entry) {
  if (!meets(nodes_[node], entries_[entry])) return;
  if (const std::uint32_t first = nodes_[node].children; first != 0) {
    for (std::uint32_t k = first; k < first + 8; ++k) insert(k, entry);
    return;
  }
  Node& leaf = nodes_[node];
  append(leaf, entry);
  if (leaf.count > kLeaf && leaf.half * leaf.count > leaf.extents && leaf.half > 1e-9 * leaf.reach()) split(node);
}

void IrradianceTree::add(const Entry& entry) {
  grow(entry);
  entries_.push_back(entry);
  insert(0, static_cast<std::uint32_t>(entries_.size() - 1));
}

}  // namespace verisim::global
