#include "tracer/bvh/hierarchy.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>
#include <utility>

#include "tracer/scene/bounds.h"

namespace verisim::accel {
namespace {

using scene::Bounds;

constexpr std::size_t kLeafSize = 4;  // ranges of so few entries are not divided
constexpr float kEmptyLimit = 1e10f;
constexpr double kBehind = 1e-10;  // boxes that end nearer are behind the ray

template <unsigned kBits>
void sort_by_digits(std::vector<std::uint64_t>& keys) {
  std::vector<std::uint64_t> other(keys.size());
  for (unsigned shift = 32; shift < 64; shift += kBits) {
    std::array<std::uint32_t, 1u << kBits> begin{};
    const auto digit = [&](std::uint64_t key) { return key >> shift & (begin.size() - 1); };
    for (const std::uint64_t key : keys) ++begin[digit(key)];
    std::exclusive_scan(begin.begin(), begin.end(), begin.begin(), 0u);
    for (const std::uint64_t key : keys) other[begin[digit(key)]++] = key;
    keys.swap(other);
  }
}

// Ascending by the upper halves; the lower ones, ascending before, keep their order where those are equal. By digits,
// as nobody foresees how comparisons end.
void sort_keys(std::vector<std::uint64_t>& keys) {
  constexpr std::size_t kSome = 64, kMany = 1000;
  if (keys.size() < kSome) return std::sort(keys.begin(), keys.end());
  if (keys.size() < kMany) return sort_by_digits<8>(keys);
  sort_by_digits<11>(keys);
}

// Half the surface, before lengths are rounded: parts of symmetric scenes are equally good but for its last bits.
double half_area(const scene::BoxUnion& box) {
  const Vec3 size = box.high - box.low;
  return size.x * (size.y + size.z) + size.y * size.z;
}

}  // namespace

std::vector<Hierarchy::Waiting>& Hierarchy::Queue::thread_list() {
  thread_local std::vector<Waiting> list;
  return list;
}

void Hierarchy::Queue::push(const Waiting& item) {
  list_.push_back(item);
  Waiting* const heap = list_.data() + begin_;
  std::size_t i = list_.size() - begin_ - 1;
  for (std::size_t parent; i > 0 && item.key < heap[parent = (i - 1) / 2].key; i = parent) heap[i] = heap[parent];
  heap[i] = item;
}

Hierarchy::Waiting Hierarchy::Queue::pop() {
  Waiting* const heap = list_.data() + begin_;
  const Waiting top = heap[0], last = list_.back();
  list_.pop_back();
  const std::size_t size = list_.size() - begin_;
  if (size == 0) return top;
  std::size_t i = 0;
  for (std::size_t child; (child = 2 * i + 1) < size; i = child) {
    // Of two equal children the right one is taken.
    if (child + 1 < size && !(heap[child].key < heap[child + 1].key)) ++child;
    if (!(last.key > heap[child].key)) break;
    heap[i] = heap[child];
  }
  heap[i] = last;
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

Hierarchy::Boxed Hierarchy::add_node(std::span<const Boxed> children) {
  Node node;
  scene::BoxUnion all;
  for (const Boxed& child : children) all.extend(child.bounds);
  node.bounds = all.bounds();
  node.first = static_cast<std::uint32_t>(children_.size());
  node.count = static_cast<std::uint32_t>(children.size());
  for (const Boxed& child : children) children_.push_back(child.node);
  nodes_.push_back(node);
  return {node.bounds, static_cast<std::uint32_t>(nodes_.size() - 1)};
}

// Stable, by twice the middle of the boxes in binary32.
void Hierarchy::sort_by_middle(std::span<Boxed> range, std::size_t axis) {
  const auto middle = [axis](const Boxed& item) { return 2 * item.bounds.low[axis] + item.bounds.size[axis]; };
  const auto before = [&](const Boxed& a, const Boxed& b) { return middle(a) < middle(b); };
  // Parts are often divided along the axis of the whole.
  if (std::is_sorted(range.begin(), range.end(), before)) return;
  constexpr std::size_t kFew = 32;
  if (range.size() <= kFew) return std::stable_sort(range.begin(), range.end(), before);
  // Of many, keys and places are sorted as whole numbers, which the order of floats is once their sign is unfolded.
  std::vector<std::uint64_t> keys(range.size());
  for (std::size_t i = 0; i < range.size(); ++i) {
    const auto bits = std::bit_cast<std::uint32_t>(middle(range[i]) + 0.0f);  // one zero
    const std::uint32_t key = bits & 0x80000000u ? ~bits : bits | 0x80000000u;
    keys[i] = std::uint64_t{key} << 32 | i;
  }
  sort_keys(keys);
  // Where they lie, without room for a copy of all: one cycle of exchanges after another.
  for (std::size_t i = 0; i < range.size(); ++i) {
    const Boxed first = range[i];
    for (std::size_t to = i;;) {
      const std::size_t from = keys[to] & 0xffffffffu;
      keys[to] = to;
      if (from == i) {
        range[to] = first;
        break;
      }
      range[to] = range[from];
      to = from;
    }
  }
}

// But what ends further away counts with its lower corner.
std::size_t Hierarchy::longest_axis(std::span<const Boxed> range) {
  float least[3] = {kEmptyLimit, kEmptyLimit, kEmptyLimit}, most[3] = {-kEmptyLimit, -kEmptyLimit, -kEmptyLimit};
  for (const Boxed& item : range) {
    const Bounds& b = item.bounds;
    for (std::size_t a = 0; a < 3; ++a) {
      least[a] = std::min(least[a], b.low[a]);
      most[a] = b.low[a] + b.size[a] > most[a] ? b.low[a] : most[a];
    }
  }
  std::size_t axis = 0;
  float longest = -std::numeric_limits<float>::max();
  for (std::size_t a = 0; a < 3; ++a)
    if (most[a] - least[a] > longest) longest = most[a] - least[a], axis = a;
  return axis;
}

// Divides a range by the surface areas of its parts, appends the nodes that it ends in. `areas`: room for one number
// each.
void Hierarchy::split(std::span<Boxed> range, std::span<double> areas, std::vector<Boxed>& nodes) {
  const std::size_t n = range.size();
  const std::size_t axis = longest_axis(range);
  sort_by_middle(range, axis);
  std::size_t best = n;
  if (n > kLeafSize) {
    scene::BoxUnion from_right;
    for (std::size_t i = n; i-- > 0;) {
      from_right.extend(range[i].bounds);
      areas[i] = half_area(from_right);
    }
    double least = areas[0] * (static_cast<double>(n) - 3);
    scene::BoxUnion from_left;
    for (std::size_t i = 0; i + 1 < n; ++i) {
      from_left.extend(range[i].bounds);
      const double cost =
          static_cast<double>(i + 1) * half_area(from_left) + static_cast<double>(n - 1 - i) * areas[i + 1];
      if (cost < least) least = cost, best = i;
    }
  }
  if (best == n) {
    nodes.push_back(add_node(range));
    return;
  }
  split(range.first(best + 1), areas, nodes);
  split(range.subspan(best + 1), areas, nodes);
}

Hierarchy::Hierarchy(std::vector<Item> items) {
  std::vector<Boxed> finite, infinite;
  nodes_.reserve(2 * items.size()), finite.reserve(items.size());
  for (const Item& item : items) {
    Node leaf;
    leaf.bounds = item.bounds;
    leaf.first = item.entry;
    leaf.infinite = item.infinite;
    (item.infinite ? infinite : finite).push_back({item.bounds, static_cast<std::uint32_t>(nodes_.size())});
    nodes_.push_back(leaf);
  }
  items = std::vector<Item>();  // before others take memory
  std::vector<double> areas(finite.size());
  std::vector<Boxed> level;
  if (!finite.empty()) split(finite, areas, level);
  while (level.size() > 1) {
    std::vector<Boxed> next;
    split(level, areas, next);
    level = std::move(next);
  }
  std::vector<Boxed> top;
  if (!infinite.empty()) {
    top.push_back(add_node(infinite));
    nodes_.back().infinite = true;
  }
  if (!level.empty()) {
    const Node finite_root = nodes_[level.front().node];
    for (std::uint32_t i = 0; i < finite_root.count; ++i) {
      const std::uint32_t child = children_[finite_root.first + i];
      top.push_back({nodes_[child].bounds, child});
    }
  }
  if (top.empty()) return;
  root_ = add_node(top).node;
  nodes_[root_].infinite = !infinite.empty();
}

void Hierarchy::find_parents() {
  parents_.assign(nodes_.size(), 0);
  std::vector<std::uint32_t> waiting;
  if (!nodes_.empty()) waiting.push_back(root_);
  while (!waiting.empty()) {
    const std::uint32_t parent = waiting.back();
    waiting.pop_back();
    for (std::uint32_t i = 0; i < nodes_[parent].count; ++i) {
      const std::uint32_t child = children_[nodes_[parent].first + i];
      parents_[child] = parent;
      if (nodes_[child].count != 0) waiting.push_back(child);
    }
  }
}

bool Hierarchy::comes_to(const Slabs& slabs, std::uint32_t entry, double& key) const {
  key = kFirst;
  double own;
  for (std::uint32_t node = entry; node != root_; node = parents_[node]) {
    if (nodes_[node].infinite) continue;
    if (!slabs.enters(nodes_[node].bounds, own)) return false;
    key = std::max(key, own);
  }
  return nodes_[root_].infinite || slabs.enters(nodes_[root_].bounds, own);
}

bool Hierarchy::reaches(const Ray& ray, std::uint32_t entry, double best) const {
  double key;
  return comes_to(Slabs(ray), entry, key) && !(key > best);
}

bool Hierarchy::any_copies(std::span<const Found> hits) const {
  const double nearest = std::ranges::min(hits, {}, &Found::t).t;
  const Node* first = nullptr;
  for (const Found& hit : hits) {
    if (hit.t != nearest) continue;
    const Node& node = nodes_[hit.entry];
    if (first && first->bounds.low == node.bounds.low && first->bounds.size == node.bounds.size) return true;
    first = &node;
  }
  return false;
}

// As long as an entry is not asked, the queue holds a box around it whose key is at most the largest on its way: so one
// with a larger key on its way is asked later. The search itself need only tell where keys are equal and the order
// matters.
std::size_t Hierarchy::settle(const Ray& ray, double best, std::span<const Found> hits) const {
  struct Turn {
    double key;
    std::size_t hit;
  };
  constexpr std::size_t kMax = 16;
  Turn turns[kMax];
  if (hits.size() > kMax || any_copies(hits)) return settle_by_search(ray, best, hits);
  const Slabs slabs(ray);
  Turn* end = turns;
  for (std::size_t i = 0; i < hits.size(); ++i)
    if (comes_to(slabs, hits[i].entry, end->key)) end++->hit = i;
  std::sort(turns, end, [](const Turn& a, const Turn& b) { return a.key < b.key; });
  std::size_t stays = hits.size();
  double nearest_yet = best;
  for (const Turn *turn = turns, *next; turn != end && turn->key <= nearest_yet; turn = next) {
    // Those whose turn comes at the same time.
    double least = std::numeric_limits<double>::infinity();
    std::size_t nearest = hits.size();
    bool equal = false, ends_search = false;
    for (next = turn; next != end && next->key == turn->key; ++next) {
      const double t = hits[next->hit].t;
      equal = t == least || (equal && t > least);
      ends_search = ends_search || t < turn->key;
      if (t < least) least = t, nearest = next->hit;
    }
    if (!(least < nearest_yet)) continue;
    if (next - turn > 1 && (equal || ends_search)) return settle_by_search(ray, best, hits);
    nearest_yet = least, stays = nearest;
  }
  return stays;
}

std::size_t Hierarchy::settle_by_search(const Ray& ray, double best, std::span<const Found> hits) const {
  std::size_t stays = hits.size(), tested = 0;
  // What else the search asks lies further away and changes nothing.
  search(ray, best, [&](std::uint32_t entry) {
    const auto hit = std::ranges::lower_bound(hits, entry, {}, &Found::entry);
    if (hit != hits.end() && hit->entry == entry) {
      if (hit->t < best) best = hit->t, stays = static_cast<std::size_t>(hit - hits.begin());
      ++tested;
    }
    return tested == hits.size() ? -std::numeric_limits<double>::infinity() : best;
  });
  return stays;
}

std::vector<std::uint32_t> Hierarchy::in_turn() const {
  std::vector<std::uint32_t> entries, waiting;
  if (!nodes_.empty()) waiting.push_back(root_);
  while (!waiting.empty()) {
    const Node& node = nodes_[waiting.back()];
    waiting.pop_back();
    if (node.count == 0) entries.push_back(node.first);
    for (std::uint32_t i = node.count; i-- > 0;) waiting.push_back(children_[node.first + i]);
  }
  return entries;
}

}  // namespace verisim::accel
