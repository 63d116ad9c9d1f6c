// The store of radiosity samples and its spatial lookup (spec 07 sections 2.5 and 2.8).
//
// POV-Ray files a sample in one cell of a lattice of cubes whose sides are powers of two, and finds it again only from inside that cell doubled. At depths
// above 0 this loses samples on purpose, which pictures show; so every sample keeps its doubled cell, and a query outside of it does not see the sample.
//
// The lookup itself is ours: a sample is entered in every cell of a finer grid that its reach meets, so that a query reads one list per size of cell, and
// most of what it reads is near enough.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tracer/math/color.h"
#include "tracer/math/vec.h"

namespace verisim::global {

struct IrradianceSample {
  Vec3 point, normal;
  Vec3 nearest_direction{0, 0, 0};  // unit, towards the nearest surface; zero if nothing was hit
  Rgb irradiance;
  float mean_distance = 0;          // harmonic, clamped by the reuse limits
  float nearest_distance = 0;
  float quality = 1;
  std::int16_t depth = 0;
  std::int16_t pass = -1;           // in which it was taken; -1: loaded from a file
  std::int32_t tile = -1;
};

class IrradianceCache {
 public:
  // error_bound: of the scene, without low_error_factor; it decides POV-Ray's cells. widest_bound: the largest bound of any query at depth 0, as a factor
  // of a sample's mean distance; queries beyond it may miss samples.
  explicit IrradianceCache(double error_bound, double widest_bound) : error_bound_(error_bound), widest_bound_(std::max(error_bound, widest_bound)) {}

  // Throws render::LimitExceeded when the samples take more memory than allowed.
  void add(const IrradianceSample& sample);
  void set_memory_limit(std::uint64_t bytes) { memory_limit_ = bytes; }
  const std::vector<IrradianceSample>& samples() const { return samples_; }
  bool empty() const { return samples_.empty(); }

  // Calls visit(sample, squared distance) for every sample of this depth that POV-Ray's lookup finds from x and that is nearer than
  // bound * its mean distance.
  template <class Visit>
  void visit(int depth, const Vec3& x, double bound, Visit&& visit) const {
    if (depth >= static_cast<int>(depths_.size())) return;
    const auto consider = [&](std::uint32_t index, bool in_root) {
      const Reach& s = reaches_[index];
      const double dx = x.x - s.point.x, dy = x.y - s.point.y, dz = x.z - s.point.z, squared = dx * dx + dy * dy + dz * dz, reach = s.mean_distance * bound;
      if (squared >= reach * reach) return;
      if (in_root == s.contains(x)) return;  // a sample of the root cell is also found from outside of its doubled cell
      visit(samples_[index], squared);
    };
    const Depth& d = depths_[static_cast<std::size_t>(depth)];
    for (const Grid& grid : d.grids) {
      for (std::int32_t c = grid.first_chunk(x); c >= 0;) {
        const Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
        for (int i = 0; i < chunk.count; ++i) consider(chunk.samples[static_cast<std::size_t>(i)], false);
        c = chunk.next;
      }
    }
    for (const std::uint32_t index : d.in_root) consider(index, true);
  }

 private:
  static constexpr double kOrigin = 1e7;  // of POV-Ray's lattice
  // What a query needs of a sample first.
  struct Reach {
    Vec3 point;
    double mean_distance;
    Vec3 center;  // of the doubled cell, and half its side
    double half;
    bool contains(const Vec3& x) const { return std::fabs(x.x - center.x) < half && std::fabs(x.y - center.y) < half && std::fabs(x.z - center.z) < half; }
  };
  struct Chunk {
    std::array<std::uint32_t, 6> samples;
    std::int32_t next = -1, count = 0;
  };
  struct Cell {
    std::int32_t x = 0, y = 0, z = 0, chunk = -1;  // -1: unused
  };
  // Cells of one size, in a hash table.
  struct Grid {
    explicit Grid(int l) : level(l), inverse_side(std::ldexp(1.0, -l)) {}
    std::int32_t first_chunk(const Vec3& x) const;
    std::int32_t& chunk_of(std::int32_t x, std::int32_t y, std::int32_t z);
    int level;
    double inverse_side;
    std::vector<Cell> cells;
    std::size_t used = 0;
  };
  struct LatticeCell {
    std::int64_t x = 0, y = 0, z = 0;
    int level = 0;
    friend bool operator==(const LatticeCell&, const LatticeCell&) = default;
  };
  struct Depth {
    std::vector<Grid> grids;
    std::vector<std::uint32_t> in_root;  // samples filed in the root cell
  };

  bool include_in_root(const LatticeCell& cell);
  void enter(std::uint32_t index, double reach);

  double error_bound_, widest_bound_;
  std::uint64_t memory_limit_ = std::numeric_limits<std::uint64_t>::max();
  std::vector<IrradianceSample> samples_;
  std::vector<Reach> reaches_;
  std::vector<Chunk> chunks_;
  std::vector<Depth> depths_;
  LatticeCell root_;  // smallest lattice cell that contains all cells in use
  bool has_root_ = false;
};

}  // namespace verisim::global
