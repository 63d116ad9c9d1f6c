#include "tracer/world/hierarchy.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace verisim::accel {
namespace {

using scene::Bounds;

constexpr std::size_t kLeafSize = 4;  // ranges of so few entries are not divided
constexpr float kEmptyLimit = 1e10f;
constexpr double kBehind = 1e-10;  // boxes that end nearer are behind the ray

float area(const Bounds& b) { return b.size[0] * (b.size[1] + b.size[2]) + b.size[1] * b.size[2]; }

// The box of several boxes: the upper corner is the binary32 sum of corner and length.
class Union {
 public:
  void add(const Bounds& b) {
    for (std::size_t i = 0; i < 3; ++i) {
      low_[i] = std::min(low_[i], b.low[i]);
      high_[i] = std::max(high_[i], b.low[i] + b.size[i]);
    }
  }
  Bounds bounds() const {
    Bounds b;
    for (std::size_t i = 0; i < 3; ++i) b.low[i] = low_[i], b.size[i] = high_[i] - low_[i];
    return b;
  }

 private:
  float low_[3] = {kEmptyLimit, kEmptyLimit, kEmptyLimit}, high_[3] = {-kEmptyLimit, -kEmptyLimit, -kEmptyLimit};
};

}  // namespace

void Hierarchy::Queue::push(const Waiting& item) {
  heap_.push_back(item);
  for (std::size_t i = heap_.size() - 1; i > 0 && heap_[i].key < heap_[(i - 1) / 2].key; i = (i - 1) / 2)
    std::swap(heap_[i], heap_[(i - 1) / 2]);
}

Hierarchy::Waiting Hierarchy::Queue::pop() {
  const Waiting top = heap_.front();
  heap_.front() = heap_.back();
  heap_.pop_back();
  for (std::size_t i = 0;;) {
    std::size_t child = 2 * i + 1;
    if (child >= heap_.size()) break;
    // Of two equal children the right one is taken.
    if (child + 1 < heap_.size() && !(heap_[child].key < heap_[child + 1].key)) ++child;
    if (!(heap_[i].key > heap_[child].key)) break;
    std::swap(heap_[i], heap_[child]);
    i = child;
  }
  return top;
}

Hierarchy::Slabs::Slabs(const Ray& ray) {
  for (int i = 0; i < 3; ++i) {
    origin_[i] = static_cast<float>(ray.origin[i]);
    const double d = ray.direction[i];
    inverse_[i] = d == 0 ? 0.0f : static_cast<float>(1 / d);
    sign_[i] = d > 0 ? 1 : d < 0 ? -1 : 0;
  }
}

bool Hierarchy::Slabs::enters(const Bounds& b, double& key) const {
  double near = -std::numeric_limits<double>::max(), far = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < 3; ++i) {
    if (sign_[i] == 0) {
      if (origin_[i] < b.low[i] || origin_[i] > b.low[i] + b.size[i]) return false;
      continue;
    }
    const double at = (b.low[i] - origin_[i]) * inverse_[i], length = b.size[i] * inverse_[i];
    const double enter = sign_[i] > 0 ? at : at + length, leave = sign_[i] > 0 ? at + length : at;
    near = std::max(near, enter);
    far = std::min(far, leave);
  }
  key = near;
  return far >= kBehind && near <= far;
}

std::uint32_t Hierarchy::add_node(std::span<const std::uint32_t> children) {
  Node node;
  Union all;
  for (const std::uint32_t child : children) all.add(nodes_[child].bounds);
  node.bounds = all.bounds();
  node.first = static_cast<std::uint32_t>(children_.size());
  node.count = static_cast<std::uint32_t>(children.size());
  children_.insert(children_.end(), children.begin(), children.end());
  nodes_.push_back(node);
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

// Divides a range by the surface areas of its parts, appends the nodes that it ends in.
void Hierarchy::split(std::span<std::uint32_t> range, std::vector<std::uint32_t>& nodes) {
  const std::size_t n = range.size();
  const auto bounds = [&](std::size_t i) -> const Bounds& { return nodes_[range[i]].bounds; };
  // The longest axis; but what ends further away counts with its lower corner.
  std::size_t axis = 0;
  float longest = -std::numeric_limits<float>::max();
  for (std::size_t a = 0; a < 3; ++a) {
    float least = kEmptyLimit, most = -kEmptyLimit;
    for (std::size_t i = 0; i < n; ++i) {
      const Bounds& b = bounds(i);
      least = std::min(least, b.low[a]);
      if (b.low[a] + b.size[a] > most) most = b.low[a];
    }
    if (most - least > longest) longest = most - least, axis = a;
  }
  const auto middle = [&](std::uint32_t i) { return 2 * nodes_[i].bounds.low[axis] + nodes_[i].bounds.size[axis]; };
  std::stable_sort(range.begin(), range.end(), [&](std::uint32_t a, std::uint32_t b) { return middle(a) < middle(b); });
  std::size_t best = n;
  if (n > kLeafSize) {
    std::vector<float> left(n), right(n);
    Union from_left, from_right;
    for (std::size_t i = 0; i < n; ++i) {
      from_left.add(bounds(i));
      left[i] = area(from_left.bounds());
      from_right.add(bounds(n - 1 - i));
      right[n - 1 - i] = area(from_right.bounds());
    }
    float least = left[n - 1] * (static_cast<float>(n) - 3);
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const float cost = static_cast<float>(i + 1) * left[i] + static_cast<float>(n - 1 - i) * right[i + 1];
      if (cost < least) least = cost, best = i;
    }
  }
  if (best == n) {
    nodes.push_back(add_node(range));
    return;
  }
  split(range.first(best + 1), nodes);
  split(range.subspan(best + 1), nodes);
}

Hierarchy::Hierarchy(std::span<const Item> items) {
  std::vector<std::uint32_t> finite, infinite;
  for (const Item& item : items) {
    Node leaf;
    leaf.bounds = item.bounds;
    leaf.entry = item.entry;
    nodes_.push_back(leaf);
    (item.infinite ? infinite : finite).push_back(static_cast<std::uint32_t>(nodes_.size() - 1));
  }
  std::vector<std::uint32_t> level;
  if (!finite.empty()) split(finite, level);
  while (level.size() > 1) {
    std::vector<std::uint32_t> next;
    split(level, next);
    level = std::move(next);
  }
  std::vector<std::uint32_t> top;
  if (!infinite.empty()) {
    for (const std::uint32_t leaf : infinite) nodes_[leaf].infinite = true;
    top.push_back(add_node(infinite));
    nodes_.back().infinite = true;
  }
  if (!level.empty()) {
    const Node finite_root = nodes_[level.front()];
    for (std::uint32_t i = 0; i < finite_root.count; ++i) top.push_back(children_[finite_root.first + i]);
  }
  if (!top.empty()) root_ = add_node(top);
}

Hierarchy::Queue& Hierarchy::scratch() {
  thread_local Queue queue;
  return queue;
}

}  // namespace verisim::accel
