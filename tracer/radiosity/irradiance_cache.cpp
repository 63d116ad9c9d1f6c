#include "tracer/radiosity/irradiance_cache.h"

#include <string>

#include "tracer/film/errors.h"

namespace verisim::global {

// Returns whether the root has changed.
bool IrradianceCache::include_in_root(const LatticeCell& cell) {
  if (!has_root_) {
    root_ = cell, has_root_ = true;
    return true;
  }
  LatticeCell a = root_, b = cell;
  // Indices are never negative: the lattice starts at -1e7.
  while (a.level < b.level) a = a.parent();
  while (b.level < a.level) b = b.parent();
  while (a != b) a = a.parent(), b = b.parent();
  const bool changed = !(a == root_);
  root_ = a;
  return changed;
}

IrradianceTree::Entry IrradianceCache::entry(std::uint32_t index) const {
  const IrradianceSample& sample = samples_[index];
  const DoubledCell& cell = doubled_cells_[index];
  const double radius = sample.mean_distance * widest_bound_ * std::ldexp(1.0, sample.depth) * (1.0 + 1e-9);
  Box3 within;
  for (int a = 0; a < 3; ++a) {
    within.min[a] = std::max(sample.point[a] - radius, cell.center[a] - cell.half);
    within.max[a] = std::min(sample.point[a] + radius, cell.center[a] + cell.half);
  }
  const float widest = std::max(sample.mean_distance, sample.nearest_distance);
  return {sample.point, sample.normal, sample.mean_distance, widest, radius, within};
}

void IrradianceCache::add(const IrradianceSample& sample) {
  const double shrink = sample.depth == 0 ? 1.0 : 8.0, scale = std::ldexp(1.0, sample.depth);
  const double reach = static_cast<double>(sample.mean_distance) * error_bound_ * scale / shrink;
  const Vec3& p = sample.point;
  if (!(reach > 0.0) || !std::isfinite(reach) || !(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) < 1e9))
    return;
  if (std::min({p.x, p.y, p.z}) < -kOrigin) return;  // before the lattice begins: in no cell that others share
  // The largest power of two that is not above the diameter.
  int level = static_cast<int>(std::floor(std::log2(static_cast<float>(2.0 * reach))));
  const double farthest = std::max({std::fabs(p.x - reach), std::fabs(p.y - reach), std::fabs(p.z - reach)}) + kOrigin;
  while (farthest / std::ldexp(1.0, level) > 1e9) ++level;
  LatticeCell cell;
  DoubledCell r{{}, 0};
  for (;; ++level) {
    const double side = std::ldexp(1.0, level);
    bool fits = true;
    double index[3];
    for (int a = 0; a < 3; ++a) {
      index[a] = std::floor((p[a] + kOrigin) / side);
      r.center[a] = (index[a] + 0.5) * side - kOrigin;
      fits &= p[a] - reach > r.center[a] - side && p[a] + reach < r.center[a] + side;
    }
    r.half = side;
    cell = {static_cast<std::int64_t>(index[0]), static_cast<std::int64_t>(index[1]),
            static_cast<std::int64_t>(index[2]), level};
    if (fits || level >= LatticeCell::kMaxLevel) break;
  }
  const auto index = static_cast<std::uint32_t>(samples_.size());
  std::size_t bytes = samples_.size() * (sizeof(IrradianceSample) + sizeof(DoubledCell) + sizeof(OctreeOrder));
  for (const Depth& d : depths_) bytes += d.tree.bytes();
  if (bytes > memory_limit_)
    throw render::LimitExceeded("radiosity samples take more than " + std::to_string(memory_limit_ >> 20) +
                                " MiB: raise error_bound or minimum_reuse, or allow more memory");
  samples_.push_back(sample);
  doubled_cells_.push_back(r);
  orders_.emplace_back(cell);
  if (static_cast<int>(depths_.size()) <= sample.depth) depths_.resize(static_cast<std::size_t>(sample.depth) + 1);
  depths_[static_cast<std::size_t>(sample.depth)].tree.add(index, [this](std::uint32_t i) { return entry(i); });
  if (include_in_root(cell)) {
    for (Depth& d : depths_) d.in_root.clear();
  }
  if (cell == root_) depths_[static_cast<std::size_t>(sample.depth)].in_root.push_back(index);
}

}  // namespace verisim::global
