#include "tracer/bvh/bvh_builder.h"

#include <algorithm>
#include <cstring>
#include <memory>

#include "tracer/base/parallel.h"

namespace verisim::accel {
namespace {

constexpr int kBins = 16;
constexpr std::size_t kSwept = 8;         // ranges up to this many items are sorted and every split is tried
constexpr std::size_t kSamples = 2048;    // of a large range, this many items at least choose the split
constexpr std::size_t kParallel = 16384;  // ranges with fewer items are one task
// What testing a node costs, in tests of one primitive. One more node for every two pairs of triangles would double the
// memory of a tree.
constexpr float kNodeCost = 2;
// Splits below this depth halve the number of items, whatever that costs: a walk's stack is finite.
constexpr int kMaxSahDepth = 36;

Float4 low_of(const BuildItem& item) { return Float4::load(item.low); }
Float4 high_of(const BuildItem& item) { return Float4::load(item.high); }

struct BuildBounds {
  Float4 low = Float4(3e37f), high = Float4(-3e37f);
  void add(Float4 l, Float4 h) { low = min(low, l), high = max(high, h); }
  void add(const BuildBounds& b) { add(b.low, b.high); }
  void add(const BuildItem& item) { add(low_of(item), high_of(item)); }
  // Half of the surface.
  float area() const {
    alignas(16) float d[4];
    (high - low).store(d);
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
};

struct Range {
  std::size_t begin = 0, end = 0;
  std::uint32_t boxes = 0;
  BuildBounds bounds, centres;  // of twice the centres: low + high
  bool leaf = false;
  std::size_t size() const { return end - begin; }
  void add(const BuildItem& item) {
    const Float4 l = low_of(item), h = high_of(item), c = l + h;
    bounds.add(l, h);
    centres.add(c, c);
    boxes += item.count();
  }
};

struct Split {
  float cost = std::numeric_limits<float>::infinity();  // area times boxes on either side, summed
  int axis = 0, bin = 0;                                // the first bin on the right
  float low = 0, scale = 0;                             // bin = (twice the centre - low) * scale
  int bin_of(const BuildItem& item) const { return static_cast<int>((item.low[axis] + item.high[axis] - low) * scale); }
};

class Builder {
 public:
  Builder(std::vector<BuildItem>& items, unsigned leaf_size)
      : items_(items), leaf_size_(leaf_size), spare_(items.size()) {}

  Range whole(std::size_t count) {
    Range range;
    range.end = count;
    for (std::size_t i = 0; i < count; ++i) range.add(items_[i]);
    return range;
  }

  // The tree of everything.
  BuiltTree tree() {
    BuiltTree built;
    const Range all = whole(items_.size());
    if (all.size() <= kParallel) {
      built.nodes.reserve(usual_nodes(all.size()));
      built.nodes.emplace_back().clear();
      node(divide(all, 0), 0, 0, built);
      return built;
    }
    Subtree root;
    upper(all, 0, root);
    // What only splits needed goes before nodes are copied: not all at once in memory.
    std::vector<BuildItem>().swap(spare_);
    std::vector<BuildItem>().swap(items_);
    join(root, built);
    return built;
  }

 private:
  // A range of so many items that its parts are built by several threads, or one of those parts.
  struct Subtree {
    BuiltTree own;  // of an upper range: its one node; of a leaf: its boxes alone
    std::unique_ptr<Subtree> child[4];
    std::uint32_t first_node = 0, first_box = 0;  // in the whole tree
  };

  // What trees of so many items hardly ever exceed: (items - 1) / 3 nodes if all are full.
  static std::size_t usual_nodes(std::size_t items) { return items <= 4 ? 1 : items / 2 + 1; }

  // What a range is cut into: up to four; one, if it is a leaf.
  struct Parts {
    Range part[4];
    int count = 1;
  };
  Parts divide(const Range& range, int depth) {
    Parts parts;
    Range* const child = parts.part;
    int& count = parts.count;
    child[0] = range;
    while (count < 4) {
      // Of those that may be split, the one with the largest surface.
      int widest = -1;
      float area = -1;
      for (int i = 0; i < count; ++i) {
        if (child[i].leaf) continue;
        const float a = child[i].bounds.area();
        if (a > area) area = a, widest = i;
      }
      if (widest < 0) break;
      Range right;
      if (split(child[widest], right, depth)) child[count++] = right;
    }
    return parts;
  }

  // Fills out.nodes[place] with parts of this depth.
  void node(const Parts& parts, std::uint32_t place, int depth, BuiltTree& out) {
    for (int i = 0; i < parts.count; ++i) {
      const std::uint32_t child = below(parts.part[i], depth + 1, out);
      set_box(out.nodes[place], i, parts.part[i].bounds);
      out.nodes[place].child[i] = child;
    }
  }
  // What a node names a part of it by. A part that nobody tried to cut yet may turn out to be a leaf: it gets no node.
  std::uint32_t below(const Range& part, int depth, BuiltTree& out) {
    if (part.leaf) return leaf(part, out);
    const Parts parts = divide(part, depth);
    if (parts.count == 1) return leaf(part, out);
    const auto place = static_cast<std::uint32_t>(out.nodes.size());
    out.nodes.emplace_back().clear();
    node(parts, place, depth, out);
    return place;
  }

  // The same for a range of more than kParallel items.
  void upper(const Range& range, int depth, Subtree& out) {
    const Parts parts = divide(range, depth);
    BoxNode& root = out.own.nodes.emplace_back();
    root.clear();
    for (int i = 0; i < parts.count; ++i) set_box(root, i, parts.part[i].bounds);
    parallel_for(static_cast<std::size_t>(parts.count), 1, [&](std::size_t i) {
      Subtree& part = *(out.child[i] = std::make_unique<Subtree>());
      if (parts.part[i].size() > kParallel) {
        upper(parts.part[i], depth + 1, part);
      } else {
        part.own.nodes.reserve(usual_nodes(parts.part[i].size()));
        root.child[i] = below(parts.part[i], depth + 1, part.own);
      }
    });
  }

  // Puts the parts one behind the other, and lets nodes and leaves name their places there. The parts are used up.
  void join(Subtree& root, BuiltTree& out) const {
    std::vector<Subtree*> parts;
    std::uint32_t nodes = 0, boxes = 0;
    const auto place = [&](const auto& self, Subtree& part) -> void {
      part.first_node = nodes, part.first_box = boxes;
      nodes += static_cast<std::uint32_t>(part.own.nodes.size()),
          boxes += static_cast<std::uint32_t>(part.own.order.size());
      parts.push_back(&part);
      for (int i = 0; i < 4 && part.child[i]; ++i) {
        Subtree& child = *part.child[i];
        self(self, child);
        if (std::uint32_t& name = part.own.nodes[0].child[i]; child.own.nodes.empty()) {
          if (leaf_size_ > 1) name += child.first_box;
        } else {
          name = child.first_node;
        }
      }
    };
    place(place, root);
    out.nodes.resize(nodes);
    out.order.resize(boxes);
    parallel_for(parts.size(), 1, [&](std::size_t k) {
      Subtree& part = *parts[k];
      std::copy(part.own.order.begin(), part.own.order.end(), out.order.begin() + part.first_box);
      BoxNode* to = out.nodes.data() + part.first_node;
      std::copy(part.own.nodes.begin(), part.own.nodes.end(), to);
      if (!part.child[0]) {
        for (std::size_t i = 0; i < part.own.nodes.size(); ++i) rename(to[i], part.first_node, part.first_box);
      }
      part.own = {};
    });
  }
  void rename(BoxNode& node, std::uint32_t first_node, std::uint32_t first_box) const {
    for (int k = 0; k < 4; ++k) {
      if (node.planes[0][k] > node.planes[3][k]) continue;  // no child
      if (!(node.child[k] & BoxNode::kLeaf)) {
        node.child[k] += first_node;
      } else if (leaf_size_ > 1) {
        node.child[k] += first_box;
      }
    }
  }

  static void set_box(BoxNode& node, int k, const BuildBounds& b) {
    alignas(16) float low[4], high[4];
    b.low.store(low), b.high.store(high);
    for (int i = 0; i < 3; ++i) node.planes[i][k] = low[i], node.planes[3 + i][k] = high[i];
  }

  std::uint32_t leaf(const Range& range, BuiltTree& out) const {
    if (leaf_size_ == 1) return BoxNode::leaf(items_[range.begin].first(), 1);
    const auto first = static_cast<std::uint32_t>(out.order.size());
    for (std::size_t i = range.begin; i < range.end; ++i)
      for (std::uint32_t k = 0; k < items_[i].count(); ++k) out.order.push_back(items_[i].first() + k);
    return BoxNode::leaf(first, range.boxes);
  }

  // Divides `range`, whose left part stays in it; false: it is a leaf now.
  bool split(Range& range, Range& right, int depth) {
    if (range.size() == 1) {
      range.leaf = true;
      return false;
    }
    alignas(16) float extent[4];
    (range.centres.high - range.centres.low).store(extent);
    const bool apart = extent[0] > 0 || extent[1] > 0 || extent[2] > 0;
    Split best;
    if (apart && depth < kMaxSahDepth) best = range.size() <= kSwept ? sweep(range, extent) : bin(range, extent);
    const auto boxes = static_cast<float>(range.boxes);
    const float area = range.bounds.area();
    if (range.boxes <= leaf_size_ && !(best.cost + kNodeCost * area < boxes * area)) {
      range.leaf = true;
      return false;
    }
    if (best.cost < std::numeric_limits<float>::infinity()) {
      if (best.scale > 0) {
        partition(range, right, best);
      } else {
        cut(range, right, range.begin + static_cast<std::size_t>(best.bin));  // sweep() has sorted the items
      }
      if (range.size() > 0 && right.size() > 0) return true;
    }
    if (range.size() == 0) std::swap(range, right);
    cut(range, right, range.begin + range.size() / 2);
    return true;
  }

  // Every split of a few items along the longest axis of their centres.
  Split sweep(const Range& range, const float* extent) {
    Split best;
    best.axis = extent[0] > extent[1] ? (extent[0] > extent[2] ? 0 : 2) : (extent[1] > extent[2] ? 1 : 2);
    const int a = best.axis;
    BuildItem* const first = items_.data() + range.begin;
    const std::size_t n = range.size();
    for (std::size_t i = 1; i < n; ++i) {
      const BuildItem item = first[i];
      const float key = item.low[a] + item.high[a];
      std::size_t place = i;
      for (; place > 0 && first[place - 1].low[a] + first[place - 1].high[a] > key; --place)
        first[place] = first[place - 1];
      first[place] = item;
    }
    float right_cost[kSwept];
    BuildBounds bounds;
    std::uint32_t boxes = 0;
    for (std::size_t i = n; --i > 0;) {
      bounds.add(first[i]);
      boxes += first[i].count();
      right_cost[i] = bounds.area() * static_cast<float>(boxes);
    }
    bounds = {}, boxes = 0;
    for (std::size_t i = 1; i < n; ++i) {
      bounds.add(first[i - 1]);
      boxes += first[i - 1].count();
      const float cost = bounds.area() * static_cast<float>(boxes) + right_cost[i];
      if (cost < best.cost) best.cost = cost, best.bin = static_cast<int>(i);
    }
    return best;
  }

  Split bin(const Range& range, const float* extent) const {
    struct Bin {
      BuildBounds bounds;
      std::uint32_t boxes = 0;
    };
    Bin bins[3][kBins];
    alignas(16) float low[4], scale[4];
    range.centres.low.store(low);
    for (int a = 0; a < 3; ++a) scale[a] = extent[a] > 0 ? kBins * 0.9999f / extent[a] : 0;
    const std::size_t step = std::max<std::size_t>(1, range.size() / kSamples);
    std::size_t sampled = 0;
    for (std::size_t i = range.begin; i < range.end; i += step) {
      const BuildItem& item = items_[i];
      const Float4 l = low_of(item), h = high_of(item);
      for (int a = 0; a < 3; ++a) {
        Bin& b = bins[a][static_cast<int>((item.low[a] + item.high[a] - low[a]) * scale[a])];
        b.bounds.add(l, h);
        b.boxes += item.count();
      }
      sampled += item.count();
    }
    Split best;
    for (int a = 0; a < 3; ++a) {
      if (!(extent[a] > 0) || !std::isfinite(scale[a])) continue;
      float right_cost[kBins];
      BuildBounds bounds;
      std::uint32_t boxes = 0;
      for (int i = kBins; --i > 0;) {
        bounds.add(bins[a][i].bounds);
        boxes += bins[a][i].boxes;
        right_cost[i] = boxes == 0 ? -1 : bounds.area() * static_cast<float>(boxes);
      }
      bounds = {}, boxes = 0;
      for (int i = 1; i < kBins; ++i) {
        bounds.add(bins[a][i - 1].bounds);
        boxes += bins[a][i - 1].boxes;
        if (boxes == 0 || right_cost[i] < 0) continue;
        const float cost = bounds.area() * static_cast<float>(boxes) + right_cost[i];
        if (cost < best.cost) best = {cost, a, i, low[a], scale[a]};
      }
    }
    best.cost *= static_cast<float>(range.boxes) / static_cast<float>(std::max<std::size_t>(sampled, 1));
    return best;
  }

  void partition(Range& range, Range& right, const Split& split) {
    Range side[2];
    BuildItem *left_end = items_.data() + range.begin, *right_end = spare_.data() + range.begin;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const BuildItem item = items_[i];
      const bool is_right = split.bin_of(item) >= split.bin;
      *left_end = *right_end = item;
      left_end += !is_right, right_end += is_right;
      side[is_right].add(item);
    }
    const auto middle = static_cast<std::size_t>(left_end - items_.data());
    std::memcpy(left_end, spare_.data() + range.begin, (range.end - middle) * sizeof(BuildItem));
    side[0].begin = range.begin, side[0].end = side[1].begin = middle, side[1].end = range.end;
    range = side[0], right = side[1];
  }

  void cut(Range& range, Range& right, std::size_t middle) const {
    Range left;
    right = {};
    left.begin = range.begin, left.end = right.begin = middle, right.end = range.end;
    for (std::size_t i = left.begin; i < left.end; ++i) left.add(items_[i]);
    for (std::size_t i = right.begin; i < right.end; ++i) right.add(items_[i]);
    range = left;
  }

  std::vector<BuildItem>& items_;
  const unsigned leaf_size_;
  std::vector<BuildItem> spare_;
};

}  // namespace

BuiltTree build_bvh(std::vector<BuildItem>& items, unsigned leaf_size) { return Builder(items, leaf_size).tree(); }

}  // namespace verisim::accel
