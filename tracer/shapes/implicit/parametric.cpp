// parametric (spec 04 section 7): the ranges of u and v are halved, cells whose box the ray misses are dropped. The
// boxes do not depend on the ray; each thread remembers those it has computed, so that neighbouring rays evaluate few
// functions.
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "tracer/functions/function.h"
#include "tracer/shapes/implicit/container.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMaxDepth = 100;  // halvings after which doubles have no finer cells
constexpr int kMaxTable = 20;   // of precompute

struct Interval {
  double low, high;
};
struct Cell {
  double u0, u1, v0, v1;
  Vec2 corner(int k) const { return {k < 2 ? u0 : u1, k % 2 == 0 ? v0 : v1}; }
};
using CellBox = std::array<Interval, 3>;
struct Half {
  Cell cell;
  CellBox box;
};

// Direct-mapped cache of cell boxes, one per thread.
struct BoxCache {
  struct Entry {
    std::uint64_t shape = 0, node = 0;
    CellBox box;
  };
  static constexpr std::size_t kSize = 1u << 15;
  std::vector<Entry> entries{kSize};
};
BoxCache& box_cache() {
  thread_local BoxCache cache;
  return cache;
}

// The corners of neighbouring cells, each once: functions are evaluated there for all cells together.
class Corners {
 public:
  static constexpr std::size_t kMaxCells = 64, kMax = 4 * kMaxCells;

  std::size_t count() const { return count_; }
  // For Function::evaluate_batch, with a stride of kMax.
  const double* arguments() const { return arguments_.data(); }
  // The number of a corner, which is added if it is new.
  std::uint16_t number_of(const Vec2& at) {
    const auto u = std::bit_cast<std::uint64_t>(at.x), v = std::bit_cast<std::uint64_t>(at.y);
    for (std::size_t place = (u ^ std::rotl(v, 21)) * 0x9e3779b97f4a7c15u >> 55;; ++place) {
      std::uint16_t& number = places_[place % places_.size()];
      if (number == 0) {  // free
        arguments_[count_] = at.x, arguments_[kMax + count_] = at.y;
        return static_cast<std::uint16_t>((number = static_cast<std::uint16_t>(++count_)) - 1);
      }
      if (std::bit_cast<std::uint64_t>(arguments_[number - 1u]) == u &&
          std::bit_cast<std::uint64_t>(arguments_[kMax + number - 1u]) == v)
        return static_cast<std::uint16_t>(number - 1);
    }
  }
  void clear() { count_ = 0, places_.fill(0); }

 private:
  std::array<double, 3 * kMax> arguments_{};  // the third is zero
  std::array<std::uint16_t, 2 * kMax> places_{};
  std::size_t count_ = 0;
};

class Parametric final : public Primitive<Parametric> {
 public:
  Parametric(const scene::Object& description, const scene::Parametric& s)
      : Primitive(description, {container_box(s.container), true}), p_(s), id_(next_id()) {
    if (p_.low.x > p_.high.x) std::swap(p_.low.x, p_.high.x);
    if (p_.low.y > p_.high.y) std::swap(p_.low.y, p_.high.y);
    if (p_.precompute_depth > 0) precompute();
    whole_box_ = box_of_all();
  }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    Vec3 o = ray.origin, d = ray.direction;
    if (has_matrix()) o = matrix().inverse_point(o), d = matrix().inverse_direction(d);
    ContainerSpan span;
    if (!intersect_container(p_.container, o, d, span)) return;
    double begin = span.enter;
    const double end = span.leave;
    if (begin == end) begin = 0;
    begin += 4 * p_.accuracy;
    if (!(begin <= end)) return;
    double best = kInfinity, u = 0, v = 0;
    search(o, d, begin, end, best, u, v);
    if (best < end)
      sink.add(
          best, [&] { return ray.at(best); }, 0, u, v);
  }

  // A hit is where the ray enters the slab of one coordinate of a small piece: perhaps before the piece (spec 04 7).
  bool may_stray() const override { return true; }
  bool contains(const Vec3&) const { return false; }
  bool formula(const Vec3&) const { return false; }

  Vec3 geometric_normal(const Hit& hit) const {
    const double a = p_.accuracy;
    const Vec3 at = surface(hit.u, hit.v);
    return world_normal(cross(surface(hit.u + a, hit.v) - at, surface(hit.u, hit.v + a) - at));
  }
  Vec2 uv(const Hit& hit) const override { return {hit.u, hit.v}; }

 private:
  static std::uint64_t next_id() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
  }

  double value(int axis, double u, double v) const {
    return (*p_.function[static_cast<std::size_t>(axis)])(
        u, v, 0);  // functions without a parameter list have three: x or u, y or v, z
  }
  Vec3 surface(double u, double v) const { return {value(0, u, v), value(1, u, v), value(2, u, v)}; }

  // Values between two ends a distance apart, if the slope is at most max_gradient.
  Interval between(double p, double q, double distance) const {
    const double margin = std::max(0.0, (p_.max_gradient * distance - std::fabs(p - q)) / 2);
    return {std::min(p, q) - margin, std::max(p, q) + margin};
  }
  // Of a cell by the values at its corners (0: low u, low v; 1: high v; 2: high u, low v; 3: both high).
  Interval enclosure(const Cell& c, const std::array<double, 4>& f) const {
    // POV-Ray subtracts the accuracy from the value: the whole surface is displaced.
    const double a = p_.accuracy;
    const Interval left = between(f[0] - a, f[1] - a, c.v1 - c.v0), right = between(f[2] - a, f[3] - a, c.v1 - c.v0);
    return {between(left.low, right.low, c.u1 - c.u0).low, between(left.high, right.high, c.u1 - c.u0).high};
  }
  Interval interval(int axis, const Cell& c) const {
    double arguments[12] = {};
    for (int k = 0; k < 4; ++k) arguments[k] = c.corner(k).x, arguments[4 + k] = c.corner(k).y;
    std::array<double, 4> f;
    p_.function[static_cast<std::size_t>(axis)]->evaluate_batch(arguments, 4, 4, f.data());
    return enclosure(c, f);
  }

  static bool split_v(const Cell& c) { return c.v1 - c.v0 > c.u1 - c.u0; }
  static Cell half(const Cell& c, bool upper) {
    Cell r = c;
    if (split_v(c))
      (upper ? r.v0 : r.v1) = (c.v0 + c.v1) / 2;
    else
      (upper ? r.u0 : r.u1) = (c.u0 + c.u1) / 2;
    return r;
  }

  // Where the box of a node is remembered.
  BoxCache::Entry& entry_of(std::uint64_t node) const {
    return box_cache().entries[(node * 0x9e3779b97f4a7c15u ^ id_ * 0xff51afd7ed558ccdu) >> 49];
  }

  // The boxes of both halves of a cell, the nodes `child` and child + 1 (0: they have no numbers). Whoever looks into a
  // cell looks at both: so functions are evaluated at eight corners at a time.
  void halve(const Cell& c, std::uint64_t child, Half halves[2]) const {
    bool known[2] = {false, false};
    for (unsigned upper = 0; upper < 2; ++upper) {
      halves[upper].cell = half(c, upper != 0);
      if (child == 0) continue;
      const BoxCache::Entry& entry = entry_of(child + upper);
      known[upper] = entry.shape == id_ && entry.node == child + upper;
      if (known[upper]) halves[upper].box = entry.box;
    }
    if (known[0] && known[1]) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (child != 0 && child + 1 < table_[axis].size()) {
        for (unsigned upper = 0; upper < 2; ++upper) halves[upper].box[axis] = table_[axis][child + upper];
      } else {
        intervals(axis, halves);
      }
    }
    for (unsigned upper = 0; upper < 2; ++upper)
      if (child != 0 && !known[upper]) entry_of(child + upper) = {id_, child + upper, halves[upper].box};
  }
  void intervals(std::size_t axis, Half halves[2]) const {
    constexpr std::size_t kCorners = 8;
    double arguments[3 * kCorners] = {};  // the third is zero
    for (int k = 0; k < static_cast<int>(kCorners); ++k) {
      const Vec2 at = halves[k / 4].cell.corner(k % 4);
      arguments[k] = at.x, arguments[kCorners + static_cast<std::size_t>(k)] = at.y;
    }
    std::array<double, kCorners> f;
    p_.function[axis]->evaluate_batch(arguments, kCorners, kCorners, f.data());
    halves[0].box[axis] = enclosure(halves[0].cell, {f[0], f[1], f[2], f[3]});
    halves[1].box[axis] = enclosure(halves[1].cell, {f[4], f[5], f[6], f[7]});
  }
  CellBox box_of_all() const {
    CellBox box;
    for (std::size_t k = 0; k < 3; ++k)
      box[k] = table_[k].size() > 1 ? table_[k][1] : interval(static_cast<int>(k), whole());
    return box;
  }

  // The last level of the table holds the intervals, the others the union of their children: node n has the children 2n
  // and 2n + 1.
  void precompute() {
    const int depth = std::min(p_.precompute_depth, kMaxTable);
    const std::uint64_t first_leaf = std::uint64_t{1} << (depth - 1);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (p_.precompute[axis]) table_[axis].resize(2 * first_leaf);
    Leaves leaves;
    add_leaves(whole(), 1, first_leaf, leaves);
    tabulate(leaves);
    for (auto& table : table_) {
      for (std::uint64_t n = table.empty() ? 0 : first_leaf - 1; n >= 1; --n) {
        table[n] = {std::min(table[2 * n].low, table[2 * n + 1].low),
                    std::max(table[2 * n].high, table[2 * n + 1].high)};
      }
    }
  }
  // Leaves that wait for the values at their corners.
  struct Leaves {
    struct Leaf {
      Cell cell;
      std::uint64_t node;
      std::array<std::uint16_t, 4> corners;
    };
    std::array<Leaf, Corners::kMaxCells> leaf;
    std::size_t count = 0;
    Corners corners;
  };
  void add_leaves(const Cell& cell, std::uint64_t node, std::uint64_t first_leaf, Leaves& leaves) {
    if (node < first_leaf) {
      add_leaves(half(cell, false), 2 * node, first_leaf, leaves);
      return add_leaves(half(cell, true), 2 * node + 1, first_leaf, leaves);
    }
    auto& leaf = leaves.leaf[leaves.count++];
    leaf.cell = cell, leaf.node = node;
    for (int k = 0; k < 4; ++k) leaf.corners[static_cast<std::size_t>(k)] = leaves.corners.number_of(cell.corner(k));
    if (leaves.count == leaves.leaf.size()) tabulate(leaves);
  }
  void tabulate(Leaves& leaves) {
    std::array<double, Corners::kMax> values;
    for (std::size_t axis = 0; axis < 3 && leaves.count > 0; ++axis) {
      if (table_[axis].empty()) continue;
      p_.function[axis]->evaluate_batch(leaves.corners.arguments(), Corners::kMax, leaves.corners.count(),
                                        values.data());
      for (const auto& leaf : std::span(leaves.leaf).first(leaves.count)) {
        const auto& at = leaf.corners;
        table_[axis][leaf.node] = enclosure(leaf.cell, {values[at[0]], values[at[1]], values[at[2]], values[at[3]]});
      }
    }
    leaves.corners.clear(), leaves.count = 0;
  }
  Cell whole() const { return {p_.low.x, p_.high.x, p_.low.y, p_.high.y}; }

  void search(const Vec3& o, const Vec3& d, double begin, double end, double& best, double& u, double& v) const {
    struct Waiting {
      Half half;
      std::uint64_t node;
      int depth;
    };
    Waiting stack[kMaxDepth + 2];
    int count = 0;
    stack[count++] = {{whole(), whole_box_}, 1, 0};
    while (count > 0) {
      const Waiting& waiting = stack[--count];
      const Cell cell = waiting.half.cell;
      const CellBox& bounds = waiting.half.box;
      const std::uint64_t node = waiting.node;
      const int depth = waiting.depth;
      // The ray parameters of the three slabs must overlap; the depth of a hit is where the last one begins.
      double low = -kInfinity, high = kInfinity, entry = 0, widest = 0;
      bool missed = false;
      for (int k = 0; k < 3 && !missed; ++k) {
        const auto [from, to] = bounds[static_cast<std::size_t>(k)];
        if (std::fabs(d[k]) < kEpsilon) {
          missed = !(o[k] >= from && o[k] <= to);
          continue;
        }
        double r0 = (from - o[k]) / d[k], r1 = (to - o[k]) / d[k];
        if (r0 > r1) std::swap(r0, r1);
        missed = r0 > end || r1 < begin || r0 > best || r0 > high || r1 < low || std::isnan(r0) || std::isnan(r1);
        low = std::max(low, r0), high = std::min(high, r1);
        entry = r0;
        widest = std::max(widest, r1 - r0);
      }
      if (missed) continue;
      const double size = std::min(std::max(cell.u1 - cell.u0, cell.v1 - cell.v0), widest);
      if (size < p_.accuracy || depth >= kMaxDepth) {
        if (entry < best && entry > begin) best = entry, u = cell.u0, v = cell.v0;
        continue;
      }
      // Node numbers beyond 64 bits are not cached.
      const std::uint64_t child = node != 0 && node < std::uint64_t{1} << 62 ? 2 * node : 0;
      Half halves[2];
      halve(cell, child, halves);
      stack[count++] = {halves[1], child ? child + 1 : 0, depth + 1};
      stack[count++] = {halves[0], child, depth + 1};
      for (std::uint64_t k = 0; k < 4; ++k) __builtin_prefetch(&entry_of(2 * child + k));  // soon asked for
    }
  }

  scene::Parametric p_;
  std::uint64_t id_;
  std::array<std::vector<Interval>, 3> table_;
  CellBox whole_box_;
};

}  // namespace

std::unique_ptr<Shape> compile_parametric(const scene::Object& object) {
  return std::make_unique<Parametric>(object, **object.as<std::shared_ptr<const scene::Parametric>>());
}
Box3 parametric_box(const scene::Parametric& parametric) { return container_box(parametric.container); }

}  // namespace verisim::shapes
