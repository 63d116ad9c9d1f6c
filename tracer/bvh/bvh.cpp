#include "tracer/bvh/bvh.h"

#include <stdexcept>

#include "tracer/bvh/shaft.h"

namespace verisim::accel {
namespace {

// Of the diagonal of everything: what rounding a ray to binary32 and following it across the volume can amount to,
// several times over.
constexpr double kSlack = 2e-6;

}  // namespace

Bvh::Bvh(std::span<const Box3> boxes)
    : Bvh(
          boxes.size(), [&](std::size_t i) { return boxes[i]; }, 1) {}

void Bvh::set_bounds(const Box3& bounds) {
  bounds_ = bounds;
  center_ = bounds.center();
  slack_ = kSlack * length(bounds.max - bounds.min) + std::numeric_limits<float>::min();
  bounds_.min -= Vec3(slack_), bounds_.max += Vec3(slack_);
}

BuildItem Bvh::item_of(const Box3& box, std::size_t index) const {
  BuildItem item;
  const Vec3 low = box.min - center_ - Vec3(slack_), high = box.max - center_ + Vec3(slack_);
  for (int i = 0; i < 3; ++i) item.low[i] = round_down(low[i]), item.high[i] = -round_down(-high[i]);
  item.set(static_cast<std::uint32_t>(index), 1);
  return item;
}

void Bvh::build(std::vector<BuildItem>& items, unsigned leaf_size) {
  if (items.size() > BoxNode::kFirstMask / 2) throw std::length_error("too many primitives for one tree");
  BuiltTree built = build_bvh(items, leaf_size);
  nodes_ = std::move(built.nodes);
  if (nodes_.capacity() > nodes_.size() + nodes_.size() / 4) nodes_.shrink_to_fit();
  order_ = std::move(built.order);
}

bool Bvh::boxes_along(const Ray& ray, double t_min, double t_max, const EntryPoints* entry, BoxesAlong& met) const {
  met.begin(t_min);
  if (nodes_.empty() || (entry && entry->count == 0)) return true;
  const Vec3 inverse(1.0 / ray.direction.x, 1.0 / ray.direction.y, 1.0 / ray.direction.z);
  double start, end;
  if (!cross_bounds(ray, inverse, t_min, t_max, start, end)) return true;
  const Vec3 from = ray.origin - center_ + start * ray.direction;
  if (!(dot(from, from) < std::numeric_limits<double>::infinity())) return true;  // as walks have it
  met.begin(start);
  const NodeRay node_ray(from, inverse);
  const float farthest = round_up(end - start + slack_);
  std::uint32_t stack[kStackSize];
  int size = 0;
  // False: there is no room.
  const auto descend = [&](const BoxNode& node) {
    alignas(16) float near[4], far[4];
    for (unsigned hits = node_ray.test(node, farthest, near, far); hits != 0; hits &= hits - 1) {
      const int k = __builtin_ctz(hits);
      if (!(node.child[k] & BoxNode::kLeaf))
        stack[size++] = node.child[k];
      else if (!met.add({near[k], far[k], BoxNode::leaf_first(node.child[k])}))
        return false;
    }
    return true;
  };
  for (int i = 0; i < (entry ? entry->count : 1); ++i)
    if (!descend(entry ? entry->nodes[i] : nodes_[0])) return false;
  while (size > 0)
    if (!descend(nodes_[stack[--size]])) return false;
  return true;
}

void Bvh::enter(const Shaft& shaft, EntryPoints& entry) const {
  constexpr signed char kBits[16] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};
  struct Subtree {
    const BoxNode* node;  // whose child it is
    int place;
    std::uint32_t child;
  };
  entry.count = 0;
  entry.complete = true;
  if (nodes_.empty()) return;
  const NodeShaft node_shaft(shaft, center_, slack_);
  Subtree lists[2][EntryPoints::kMax];
  Subtree *now = lists[0], *later = lists[1];
  int size = 0;
  const auto add_children = [&](const BoxNode& node, unsigned met, Subtree* list, int& count) {
    for (; met != 0; met &= met - 1) {
      const int k = __builtin_ctz(met);
      list[count++] = {&node, k, node.child[k]};
    }
  };
  add_children(nodes_[0], node_shaft.test(nodes_[0]), now, size);
  // A level at a time, as long as there is room.
  for (bool grew = true; grew;) {
    grew = false;
    int count = 0;
    for (int i = 0; i < size; ++i) {
      const std::uint32_t child = now[i].child;
      if (!(child & BoxNode::kLeaf)) {
        const unsigned met = node_shaft.test(nodes_[child]);
        if (count + kBits[met] + (size - i - 1) <= EntryPoints::kMax) {
          add_children(nodes_[child], met, later, count);
          grew = true;
          continue;
        }
      }
      later[count++] = now[i];
    }
    std::swap(now, later);
    size = count;
  }
  entry.count = (size + 3) / 4;
  for (int n = 0; n < entry.count; ++n) {
    BoxNode& node = entry.nodes[n];
    if (4 * n + 4 > size) node.clear();
    for (int k = 0; k < 4 && 4 * n + k < size; ++k) {
      const Subtree& s = now[4 * n + k];
      for (int i = 0; i < 6; ++i) node.planes[i][k] = s.node->planes[i][s.place];
      node.child[k] = s.child;
      if (!(s.child & BoxNode::kLeaf)) entry.complete = false;
    }
  }
}

}  // namespace verisim::accel
