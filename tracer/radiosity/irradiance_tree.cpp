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

std::uint32_t IrradianceTree::beside(const Cube& cube, const Entry& entry) {
  constexpr std::uint32_t kUpper[3] = {0xAA, 0xCC, 0xF0};  // the octants of the upper half along each axis
  const double margin = 1e-11 * cube.reach();
  std::uint32_t octants = 0;
  for (int a = 0; a < 3; ++a) {
    if (entry.within.max[a] < cube.center[a] - margin) octants |= kUpper[a];
    if (entry.within.min[a] > cube.center[a] + margin) octants |= ~kUpper[a];
  }
  return octants & 0xFF;
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

void IrradianceTree::append(Leaf& leaf, const Cube& cube, std::uint32_t sample, const Entry& entry) {
  const std::uint32_t lane = leaf.count++ % IrradiancePacket::kCount;
  if (lane == 0) {
    // Not twice as much as is there: lists are many and short.
    const std::size_t size = leaf.packets.size();
    if (size == leaf.packets.capacity()) leaf.packets.reserve(size + size / 4 + 1);
    leaf.packets.emplace_back();
    ++packets_;
  }
  const Vec3 p = entry.point - cube.center;
  const double farthest = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  if (leaf.unit == 0) leaf.unit = std::max(cube.half / IrradiancePacket::kScale, 1e-300);
  while (farthest > leaf.unit * IrradiancePacket::kScale) {
    for (IrradiancePacket& packet : leaf.packets) packet.double_unit();
    leaf.unit *= 2;
  }
  leaf.packets.back().set(lane, {p / leaf.unit, entry.normal, entry.mean_distance, entry.widest, sample});
  leaf.extents += entry.extent();
}

// Eight leaves in place of one; the first of them in its room.
IrradianceTree::Node IrradianceTree::split(Node leaf, const Cube& cube, const Entries& entries) {
  const Leaf whole = std::move(leaves_[leaf.number]);
  packets_ -= whole.packets.size();
  leaves_[leaf.number] = Leaf();
  Branch branch;
  for (std::uint32_t octant = 0; octant < 8; ++octant) branch[octant] = octant == 0 ? leaf : add_leaf();
  for (std::uint32_t i = 0; i < whole.count; ++i) {
    const std::uint32_t sample = whole.packets[i / IrradiancePacket::kCount].sample[i % IrradiancePacket::kCount];
    const Entry entry = entries(sample);
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      const Cube child = cube.child(octant);
      if (meets(child, entry)) append(leaves_[branch[octant].number], child, sample, entry);
    }
  }
  branches_.push_back(branch);
  Node node;
  node.number = static_cast<std::uint32_t>(branches_.size() - 1) & 0x7FFFFFFFu;
  return node;
}

void IrradianceTree::insert(Node& node, const Cube& cube, std::uint32_t sample, const Entry& entry,
                            const Entries& entries) {
  if (!meets(cube, entry)) return;
  if (!node.leaf) {
    const std::uint32_t far = beside(cube, entry);
    // By number: lists may grow below.
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      if (far >> octant & 1) continue;
      Node child = branches_[node.number][octant];
      insert(child, cube.child(octant), sample, entry, entries);
      branches_[node.number][octant] = child;
    }
    return;
  }
  Leaf& leaf = leaves_[node.number];
  append(leaf, cube, sample, entry);
  if (leaf.count > kSmall && cube.half * leaf.count > leaf.extents && cube.half > 1e-9 * cube.reach())
    node = split(node, cube, entries);
}

void IrradianceTree::add(std::uint32_t sample, const Entries& entries) {
  const Entry entry = entries(sample);
  grow(entry);
  insert(root_, root_cube_, sample, entry, entries);
}

}  // namespace verisim::global
