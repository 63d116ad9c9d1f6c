#include "tracer/radiosity/irradiance_tree.h"

namespace verisim::global {

bool IrradianceTree::contains(const Cube& cube, const Box3& box) {
  for (int a = 0; a < 3; ++a) {
    if (!(box.min[a] >= cube.center[a] - cube.half && box.max[a] <= cube.center[a] + cube.half)) return false;
  }
  return true;
}

bool IrradianceTree::meets(const Cube& cube, const Entry& entry) {
  const double half = cube.half + 1e-12 * cube.reach();  // sides of neighbours may be apart by their rounding
  double squared = 0;
  for (int a = 0; a < 3; ++a) {
    const double low = cube.center[a] - half, high = cube.center[a] + half;
    if (entry.within.min[a] > high || entry.within.max[a] < low) return false;
    const double gap = std::max({0.0, low - entry.point[a], entry.point[a] - high});
    squared += gap * gap;
  }
  return squared <= entry.radius * entry.radius * (1.0 + 1e-9);
}

IrradianceTree::Node IrradianceTree::add_leaf() {
  leaves_.emplace_back();
  Node node;
  node.number = static_cast<std::uint32_t>(leaves_.size() - 1) & 0x7FFFFFFFu, node.leaf = 1;
  return node;
}

// Doubles the root until it holds all from where the entry is found.
void IrradianceTree::grow(const Entry& entry) {
  if (empty_) {
    empty_ = false;
    root_ = add_leaf();
    root_cube_ = {entry.point, 0};
    root_cube_.half = std::max(entry.extent(), 1e-6 * root_cube_.reach());
  }
  while (!contains(root_cube_, entry.within)) {
    const Vec3 center = root_cube_.center, to = entry.point - center;
    const double half = root_cube_.half;
    const Cube wider{{center.x + (to.x >= 0 ? half : -half), center.y + (to.y >= 0 ? half : -half),
                      center.z + (to.z >= 0 ? half : -half)},
                     2.0 * half};
    Branch branch;
    for (std::uint32_t octant = 0; octant < 8; ++octant)
      branch[octant] = octant == wider.octant(center) ? root_ : add_leaf();
    branches_.push_back(branch);
    root_.number = static_cast<std::uint32_t>(branches_.size() - 1) & 0x7FFFFFFFu, root_.leaf = 0;
    root_cube_ = wider;
  }
}

void IrradianceTree::append(Leaf& leaf, const Vec3& center, std::uint32_t entry) {
  const Entry& e = entries_[entry];
  const std::uint32_t lane = leaf.count++ % IrradiancePacket::kCount;
  if (lane == 0) {
    IrradiancePacket& fresh = leaf.lanes.emplace_back();
    std::fill_n(fresh.point[0], IrradiancePacket::kCount, 1e18f);
    ++lanes_;
  }
  IrradiancePacket& to = leaf.lanes.back();
  const Vec3 p = e.point - center;
  for (int a = 0; a < 3; ++a)
    to.point[a][lane] = static_cast<float>(p[a]), to.normal[a][lane] = static_cast<float>(e.normal[a]);
  to.mean_distance[lane] = e.mean_distance, to.widest[lane] = e.widest;
  to.entry[lane] = entry, to.sample[lane] = e.sample;
  leaf.farthest = std::max({leaf.farthest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  leaf.extents += e.extent();
}

// Eight leaves in place of one; the first of them in its room.
IrradianceTree::Node IrradianceTree::split(Node leaf, const Cube& cube) {
  const Leaf whole = std::move(leaves_[leaf.number]);
  lanes_ -= whole.lanes.size();
  leaves_[leaf.number] = Leaf();
  Branch branch;
  for (std::uint32_t octant = 0; octant < 8; ++octant) branch[octant] = octant == 0 ? leaf : add_leaf();
  for (std::uint32_t i = 0; i < whole.count; ++i) {
    const std::uint32_t entry = whole.lanes[i / IrradiancePacket::kCount].entry[i % IrradiancePacket::kCount];
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      const Cube child = cube.child(octant);
      if (meets(child, entries_[entry])) append(leaves_[branch[octant].number], child.center, entry);
    }
  }
  branches_.push_back(branch);
  Node node;
  node.number = static_cast<std::uint32_t>(branches_.size() - 1) & 0x7FFFFFFFu;
  return node;
}

void IrradianceTree::insert(Node& node, const Cube& cube, std::uint32_t entry) {
  if (!meets(cube, entries_[entry])) return;
  if (!node.leaf) {
    // By number: lists may grow below.
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      Node child = branches_[node.number][octant];
      insert(child, cube.child(octant), entry);
      branches_[node.number][octant] = child;
    }
    return;
  }
  Leaf& leaf = leaves_[node.number];
  append(leaf, cube.center, entry);
  if (leaf.count > kSmall && cube.half * leaf.count > leaf.extents && cube.half > 1e-9 * cube.reach())
    node = split(node, cube);
}

void IrradianceTree::add(const Entry& entry) {
  grow(entry);
  entries_.push_back(entry);
  insert(root_, root_cube_, static_cast<std::uint32_t>(entries_.size() - 1));
}

}  // namespace verisim::global
