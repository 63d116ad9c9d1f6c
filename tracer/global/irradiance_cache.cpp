#include "tracer/global/irradiance_cache.h"

#include <string>

#include "tracer/render/render.h"

namespace verisim::global {
namespace {

std::size_t hash(std::int32_t x, std::int32_t y, std::int32_t z) {
  std::uint64_t h = static_cast<std::uint32_t>(x) * 0x9E3779B97F4A7C15ull;
  h = (h ^ (h >> 29) ^ static_cast<std::uint32_t>(y)) * 0xBF58476D1CE4E5B9ull;
  h = (h ^ (h >> 32) ^ static_cast<std::uint32_t>(z)) * 0x94D049BB133111EBull;
  return static_cast<std::size_t>(h ^ (h >> 32));
}

// Cell index of a coordinate; queries from far outside of all cells are kept in range.
std::int32_t index_of(double scaled) { return static_cast<std::int32_t>(std::floor(std::clamp(scaled, -2e9, 2e9))); }

}  // namespace

std::int32_t IrradianceCache::Grid::first_chunk(const Vec3& p) const {
  const std::int32_t x = index_of(p.x * inverse_side), y = index_of(p.y * inverse_side), z = index_of(p.z * inverse_side);
  const std::size_t mask = cells.size() - 1;
  for (std::size_t i = hash(x, y, z) & mask;; i = (i + 1) & mask) {
    const Cell& c = cells[i];
    if (c.chunk < 0 || (c.x == x && c.y == y && c.z == z)) return c.chunk;
  }
}

std::int32_t& IrradianceCache::Grid::chunk_of(std::int32_t x, std::int32_t y, std::int32_t z) {
  const auto find = [&](std::int32_t a, std::int32_t b, std::int32_t c) -> Cell& {
    const std::size_t mask = cells.size() - 1;
    std::size_t i = hash(a, b, c) & mask;
    while (cells[i].chunk >= 0 && (cells[i].x != a || cells[i].y != b || cells[i].z != c)) i = (i + 1) & mask;
    return cells[i];
  };
  if (2 * (used + 1) > cells.size()) {
    std::vector<Cell> old(std::max<std::size_t>(64, cells.size() * 2));
    old.swap(cells);
    for (const Cell& c : old) {
      if (c.chunk >= 0) find(c.x, c.y, c.z) = c;
    }
  }
  Cell& cell = find(x, y, z);
  if (cell.chunk < 0) ++used, cell = {x, y, z, -1};
  return cell.chunk;
}

// Returns whether the root has changed.
bool IrradianceCache::include_in_root(const LatticeCell& cell) {
  if (!has_root_) {
    root_ = cell, has_root_ = true;
    return true;
  }
  LatticeCell a = root_, b = cell;
  // Indices are never negative: the lattice starts at -1e7.
  const auto parent = [](const LatticeCell& c) { return LatticeCell{c.x >> 1, c.y >> 1, c.z >> 1, c.level + 1}; };
  while (a.level < b.level) a = parent(a);
  while (b.level < a.level) b = parent(b);
  while (a.x != b.x || a.y != b.y || a.z != b.z) a = parent(a), b = parent(b);
  const bool changed = !(a == root_);
  root_ = a;
  return changed;
}

// Lists the sample in all cells that both its reach and its doubled cell meet.
void IrradianceCache::enter(std::uint32_t index, double radius) {
  const Reach& r = reaches_[index];
  const double extent = std::min(radius, r.half);
  // One or two cells from the middle to the rim: finer ones give shorter lists, but so many cells that the cache misses them.
  int level = static_cast<int>(std::ceil(std::log2(extent)));
  const double farthest = std::max({std::fabs(r.point.x), std::fabs(r.point.y), std::fabs(r.point.z)}) + extent;
  while (farthest * std::ldexp(1.0, -level) > 1e9) ++level;
  auto& grids = depths_[static_cast<std::size_t>(samples_[index].depth)].grids;
  auto grid = std::find_if(grids.begin(), grids.end(), [level](const Grid& g) { return g.level == level; });
  if (grid == grids.end()) grid = grids.insert(grids.end(), Grid(level));
  const double inverse = grid->inverse_side, side = std::ldexp(1.0, level);
  std::int32_t first[3], last[3];
  for (int a = 0; a < 3; ++a) {
    first[a] = index_of(std::max(r.point[a] - radius, r.center[a] - r.half) * inverse);
    last[a] = index_of(std::min(r.point[a] + radius, r.center[a] + r.half) * inverse);
  }
  const double most = radius * radius * (1.0 + 1e-9);
  const auto gap = [&](int a, std::int32_t i) {  // from the point to the cell along one axis
    const double low = i * side;
    return std::max({0.0, low - r.point[a], r.point[a] - (low + side)});
  };
  for (std::int32_t z = first[2]; z <= last[2]; ++z) {
    const double gz = gap(2, z);
    for (std::int32_t y = first[1]; y <= last[1]; ++y) {
      const double gy = gap(1, y), gyz = gz * gz + gy * gy;
      if (gyz > most) continue;
      for (std::int32_t x = first[0]; x <= last[0]; ++x) {
        const double gx = gap(0, x);
        if (gyz + gx * gx > most) continue;
        std::int32_t& head = grid->chunk_of(x, y, z);
        if (head < 0 || chunks_[static_cast<std::size_t>(head)].count == static_cast<int>(Chunk().samples.size())) {
          chunks_.push_back({{}, head, 0});
          head = static_cast<std::int32_t>(chunks_.size()) - 1;
        }
        Chunk& chunk = chunks_[static_cast<std::size_t>(head)];
        chunk.samples[static_cast<std::size_t>(chunk.count++)] = index;
      }
    }
  }
}

void IrradianceCache::add(const IrradianceSample& sample) {
  const double shrink = sample.depth == 0 ? 1.0 : 8.0, scale = std::ldexp(1.0, sample.depth);
  const double reach = static_cast<double>(sample.mean_distance) * error_bound_ * scale / shrink;
  const Vec3& p = sample.point;
  if (!(reach > 0.0) || !std::isfinite(reach) || !(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) < 1e9)) return;
  // The largest power of two that is not above the diameter.
  int level = static_cast<int>(std::floor(std::log2(static_cast<float>(2.0 * reach))));
  const double farthest = std::max({std::fabs(p.x - reach), std::fabs(p.y - reach), std::fabs(p.z - reach)}) + kOrigin;
  while (farthest / std::ldexp(1.0, level) > 1e9) ++level;
  LatticeCell cell;
  Reach r{p, sample.mean_distance, {}, 0};
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
    cell = {static_cast<std::int64_t>(index[0]), static_cast<std::int64_t>(index[1]), static_cast<std::int64_t>(index[2]), level};
    if (fits || level > 60) break;
  }
  const auto index = static_cast<std::uint32_t>(samples_.size());
  // Hash tables hold at most as much again as the lists they lead to.
  if (samples_.size() * (sizeof(IrradianceSample) + sizeof(Reach)) + 2 * chunks_.size() * sizeof(Chunk) > memory_limit_)
    throw render::LimitExceeded("radiosity samples take more than " + std::to_string(memory_limit_ >> 20) +
                                " MiB: raise error_bound or minimum_reuse, or allow more memory");
  samples_.push_back(sample);
  reaches_.push_back(r);
  if (static_cast<int>(depths_.size()) <= sample.depth) depths_.resize(static_cast<std::size_t>(sample.depth) + 1);
  enter(index, sample.mean_distance * widest_bound_ * scale);
  if (include_in_root(cell)) {
    for (Depth& d : depths_) d.in_root.clear();
  }
  if (cell == root_) depths_[static_cast<std::size_t>(sample.depth)].in_root.push_back(index);
}

}  // namespace verisim::global
