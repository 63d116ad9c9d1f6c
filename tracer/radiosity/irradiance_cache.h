// The store of radiosity samples and its spatial lookup (spec 07 sections 2.5 and 2.8).
//
// POV-Ray files a sample in one cell of a lattice of cubes whose sides are powers of two, and finds it again only from
// inside that cell doubled. At depths above 0 this loses samples on purpose, which pictures show; so every sample keeps
// its doubled cell, and a query outside of it does not see the sample.
//
// The lookup itself is ours: one IrradianceTree a depth.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tracer/radiosity/irradiance_tree.h"
#include "tracer/radiosity/octree_order.h"
#include "tracer/math/color.h"
#include "tracer/math/vec.h"

namespace verisim::global {

struct IrradianceSample {
  Vec3 point, normal;
  Vec3 nearest_direction{0, 0, 0};  // unit, towards the nearest surface; zero if nothing was hit
  Rgb irradiance;
  float mean_distance = 0;  // harmonic, clamped by the reuse limits
  float nearest_distance = 0;
  float quality = 1;
  std::int16_t depth = 0;
  std::int16_t pass = -1;  // in which it was taken; -1: loaded from a file
  std::int32_t tile = -1;
};

class IrradianceCache {
 public:
  // error_bound: of the scene, without low_error_factor; it decides POV-Ray's cells. widest_bound: the largest bound of
  // any query at depth 0, as a factor of a sample's mean distance; queries beyond it may miss samples.
  explicit IrradianceCache(double error_bound, double widest_bound)
      : error_bound_(error_bound), widest_bound_(std::max(error_bound, widest_bound)) {}

  // Throws render::LimitExceeded when the samples take more memory than allowed.
  void add(const IrradianceSample& sample);
  void set_memory_limit(std::uint64_t bytes) { memory_limit_ = bytes; }
  const std::vector<IrradianceSample>& samples() const { return samples_; }
  bool empty() const { return samples_.empty(); }
  // When POV-Ray's lookup comes to a sample of this cache: the last that was filed in a cell is the first of it.
  struct Turn {
    OctreeOrder cell;
    const IrradianceSample* sample;
    friend bool operator<(const Turn& a, const Turn& b) {
      return a.cell < b.cell || (a.cell == b.cell && a.sample > b.sample);
    }
  };
  Turn turn_of(const IrradianceSample& sample) const { return {orders_[&sample - samples_.data()], &sample}; }

  // Calls visit(sample, squared distance) for every sample of this depth that POV-Ray's lookup finds from x and that is
  // nearer than bound * its mean distance, in the order they were added. Those may be left out of which the larger of
  // their mean and nearest distances and their normal tell that their error (spec 07 2.5) is above the bound.
  template <class Visit>
  void visit(int depth, const Vec3& x, double bound, const Vec3& normal, Visit&& visit) const {
    if (depth >= static_cast<int>(depths_.size())) return;
    const Depth& d = depths_[static_cast<std::size_t>(depth)];
    const auto consider = [&](std::uint32_t index, bool in_root) {
      const IrradianceSample& s = samples_[index];
      const Vec3 delta = x - s.point;
      const double squared = dot(delta, delta), reach = s.mean_distance * bound;
      if (squared >= reach * reach) return;
      if (in_root == doubled_cells_[index].contains(x))
        return;  // a sample of the root cell is also found from outside of its doubled cell
      visit(s, squared);
    };
    // Samples lie about in memory: the next ones are on their way while some are looked at.
    std::uint32_t found[kAhead];
    int count = 0;
    const auto consider_found = [&] {
      for (int i = 0; i < count; ++i) consider(found[i], false);
      count = 0;
    };
    d.tree.visit(x, bound, normal, [&](std::uint32_t index) {
      const char* const sample = reinterpret_cast<const char*>(&samples_[index]);
      __builtin_prefetch(sample), __builtin_prefetch(sample + 64), __builtin_prefetch(&doubled_cells_[index]);
      found[count++] = index;
      if (count == kAhead) consider_found();
    });
    consider_found();
    for (const std::uint32_t index : d.in_root) consider(index, true);
  }

 private:
  static constexpr int kAhead = 32;
  static constexpr double kOrigin = 1e7;  // of POV-Ray's lattice
  struct DoubledCell {
    Vec3 center;
    double half;  // of the side
    bool contains(const Vec3& x) const {
      return std::fabs(x.x - center.x) < half && std::fabs(x.y - center.y) < half && std::fabs(x.z - center.z) < half;
    }
  };
  struct Depth {
    IrradianceTree tree;
    std::vector<std::uint32_t> in_root;  // samples filed in the root cell
  };

  bool include_in_root(const LatticeCell& cell);
  IrradianceTree::Entry entry(std::uint32_t index) const;  // of a sample, for its tree

  double error_bound_, widest_bound_;
  std::uint64_t memory_limit_ = std::numeric_limits<std::uint64_t>::max();
  std::vector<IrradianceSample> samples_;
  std::vector<DoubledCell> doubled_cells_;
  std::vector<OctreeOrder> orders_;
  std::vector<Depth> depths_;
  LatticeCell root_;  // smallest lattice cell that contains all cells in use
  bool has_root_ = false;
};

}  // namespace verisim::global
