// Candidates for the photons nearest to a point. Floats find them, four at a time and with margins for their rounding; PhotonMap decides in double.
//
// Both structures visit candidates in the order of the map, so that what is found does not depend on which of them was asked.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "tracer/accel/float4.h"
#include "tracer/math/vec.h"

namespace verisim::global {

// Four floats from anywhere.
inline accel::Float4 load_floats(const float* p) {
#if defined(__SSE2__)
  return _mm_loadu_ps(p);
#else
  return accel::Float4::load(p);
#endif
}

// Coordinates side by side; arrays end with a few floats that nobody asks for.
struct PhotonPositions {
  std::vector<float> x, y, z;
  void resize(std::size_t n);
  void set(std::size_t i, float px, float py, float pz) { x[i] = px, y[i] = py, z[i] = pz; }
};

// A point in floats, and how far from it a float may say a photon is whose squared distance is below a limit.
class FloatPoint {
 public:
  explicit FloatPoint(const Vec3& p)
      : x(static_cast<float>(p.x)), y(static_cast<float>(p.y)), z(static_cast<float>(p.z)),
        error_(4e-7 * (std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z))) {}
  accel::Float4 limit(double squared) const {
    const double r = std::sqrt(squared) + error_;
    return accel::Float4(static_cast<float>(std::min(r * r * (1.0 + 1e-5), 1e38)));
  }
  // Which of the four photons from i on are near.
  unsigned near(const PhotonPositions& p, std::size_t i, accel::Float4 limit) const {
    using accel::Float4;
    const Float4 dx = load_floats(p.x.data() + i) - x, dy = load_floats(p.y.data() + i) - y,
                 dz = load_floats(p.z.data() + i) - z;
    return (dx * dx + dy * dy + dz * dz <= limit).bits();
  }

  accel::Float4 x, y, z;

 private:
  double error_;
};

// All photons of a map.
class PhotonTree {
 public:
  // `position(i)` is a std::array<float, 3>; photon (first + last) / 2 of a range [first, last] is the median of one coordinate, and so on within.
  template <class Position>
  void build(std::size_t count, Position&& position) {
    positions_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::array<float, 3>& p = position(i);
      positions_.set(i, p[0], p[1], p[2]);
    }
    build_nodes(count);
  }
  // Calls visit(index) for all photons whose squared distance from p is below `limit`, and some more. visit may lower the limit.
  template <class Visit>
  void visit(const Vec3& p, const double& limit, Visit&& visit) const;

 private:
  static constexpr std::uint32_t kLeaf = 16;  // photons
  struct alignas(16) Node {
    std::array<float, 4> low[3], high[3];
    std::array<std::uint32_t, 4> first, count;  // photons of a leaf, or, with count 0, a node's number
  };
  // Photons [first, end), sorted like the map except for the last `extra` ones, which are medians of larger ranges.
  struct Range {
    std::uint32_t first, end, extra;
    std::uint32_t size() const { return end - first; }
  };
  static std::array<Range, 2> halves(const Range& r);
  void build_nodes(std::size_t count);
  std::uint32_t add_node(const Range& range);
  void set_bounds(Node& node, std::size_t lane, const Range& range) const;

  PhotonPositions positions_;
  std::vector<Node> nodes_;
};

// A cube of a lattice with sides that are powers of two.
struct LatticeCube {
  std::int64_t x = 0, y = 0, z = 0;
  int level = 0;
  // With sides of at most `side`, around p; `valid`: the numbers are in range.
  LatticeCube() = default;
  LatticeCube(const Vec3& p, double side, bool& valid);
  std::uint64_t hash() const;
  Vec3 center() const;
  double side() const { return std::ldexp(1.0, level); }
  bool operator==(const LatticeCube&) const = default;
};

// What one thread remembers of searches in one map. Points that are searched from lie close together when a picture is fine, or where a ray goes through
// media: the radius that was enough nearby is a good guess, and candidates are kept for all points of a small cube.
class PhotonNeighbourhoods {
 public:
  struct Cell {
    LatticeCube cube;
    int asked = 0;  // 0: unused
    bool filled = false;
    double reach = 0;           // all photons nearer to the centre are in the cell
    Vec3 center;
    PhotonPositions positions;  // relative to the centre
    std::vector<std::uint32_t> indices;

    template <class Visit>
    void visit(const Vec3& p, const double& limit, Visit&& visit) const;
  };
  // The radius that was enough near p, for searches within `radius`; what is written is remembered. 0: nothing known.
  double& guess(const Vec3& p, double radius);
  // The cell around p for searches that need about this radius and never more than `most`; null: it is not worth it. `fill(cell)` enters the photons
  // within cell.reach, and returns false if they are too many.
  template <class Fill>
  const Cell* around(const Vec3& p, double radius, double most, Fill&& fill);

 private:
  static constexpr std::size_t kCells = 2048, kGuesses = 4096;
  static constexpr int kWorthIt = 2;  // searches in a cell before it is filled
  std::vector<Cell> cells_;
  std::vector<double> guesses_;
  double no_guess_ = 0;
};

template <class Visit>
void PhotonTree::visit(const Vec3& p, const double& limit, Visit&& visit) const {
  using accel::Float4;
  if (nodes_.empty()) return;
  const FloatPoint point(p);
  const Float4 zero(0.0f);
  double known = limit;
  Float4 reach = point.limit(known);
  struct Entry {
    std::uint32_t first, count;
  };
  std::array<Entry, 4 * 32> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (limit != known) known = limit, reach = point.limit(known);
    if (entry.count > 0) {
      for (std::uint32_t i = 0; i < entry.count; i += 4) {
        unsigned bits = point.near(positions_, entry.first + i, reach);
        if (entry.count - i < 4) bits &= (1u << (entry.count - i)) - 1;
        for (; bits != 0; bits &= bits - 1) visit(entry.first + i + static_cast<std::uint32_t>(std::countr_zero(bits)));
      }
      continue;
    }
    const Node& node = nodes_[entry.first];
    const auto gap = [&](std::size_t axis, Float4 at) {
      return max(zero, max(Float4::load(node.low[axis].data()) - at, at - Float4::load(node.high[axis].data())));
    };
    const Float4 x = gap(0, point.x), y = gap(1, point.y), z = gap(2, point.z);
    const unsigned bits = (x * x + y * y + z * z <= reach).bits();
    for (std::size_t lane = 4; lane-- > 0;) {
      if (bits >> lane & 1) stack[depth++] = {node.first[lane], node.count[lane]};
    }
  }
}

template <class Visit>
void PhotonNeighbourhoods::Cell::visit(const Vec3& p, const double& limit, Visit&& visit) const {
  const Vec3 relative = p - center;
  const FloatPoint point(relative);
  // Photons' own coordinates are rounded, too.
  const double rounding = 4e-7 * reach, r = std::sqrt(limit) + rounding;
  const accel::Float4 near = point.limit(r * r);
  for (std::size_t i = 0; i < indices.size(); i += 4) {
    for (unsigned bits = point.near(positions, i, near); bits != 0; bits &= bits - 1) {
      const std::size_t k = i + static_cast<std::size_t>(std::countr_zero(bits));
      if (k < indices.size()) visit(indices[k]);
    }
  }
}

template <class Fill>
const PhotonNeighbourhoods::Cell* PhotonNeighbourhoods::around(const Vec3& p, double radius, double most, Fill&& fill) {
  constexpr double kSide = 0.5, kSpare = 1.25;  // of the radius
  bool valid;
  const LatticeCube cube(p, kSide * radius, valid);
  if (!valid) return nullptr;
  if (cells_.empty()) cells_.resize(kCells);
  Cell& cell = cells_[cube.hash() % kCells];
  if (cell.asked == 0 || !(cell.cube == cube)) {
    cell.cube = cube, cell.asked = 1, cell.filled = false;
    return nullptr;
  }
  if (cell.filled) return &cell;
  if (cell.asked > kWorthIt || ++cell.asked <= kWorthIt) return nullptr;  // too many photons, or not yet
  cell.center = cube.center();
  const double corner = 0.8661 * cube.side();
  cell.reach = std::min(kSpare * radius, most) + corner;
  cell.filled = fill(cell);
  return cell.filled ? &cell : nullptr;
}

}  // namespace verisim::global
