#include "tracer/global/irradiance_cache.h"

#include <algorithm>

namespace verisim::global {

std::uint64_t IrradianceCache::hash(const Key& k) {
  std::uint64_t h = static_cast<std::uint32_t>(k.x) * 0x9E3779B97F4A7C15ull;
  h = (h ^ (h >> 29) ^ static_cast<std::uint32_t>(k.y)) * 0xBF58476D1CE4E5B9ull;
  h = (h ^ (h >> 32) ^ static_cast<std::uint32_t>(k.z)) * 0x94D049BB133111EBull;
  h ^= static_cast<std::uint64_t>(static_cast<std::uint16_t>(k.level)) << 16 ^ static_cast<std::uint16_t>(k.depth);
  h *= 0xD6E8FEB86659FD93ull;
  return h ^ (h >> 32);
}

std::int32_t IrradianceCache::head(const Key& key) const {
  if (slots_.empty()) return -1;
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = hash(key) & mask;; i = (i + 1) & mask) {
    if (slots_[i].head < 0) return -1;
    if (slots_[i].key == key) return slots_[i].head;
  }
}

IrradianceCache::Slot& IrradianceCache::slot(const Key& key) {
  if (2 * (used_ + 1) > slots_.size()) {
    std::vector<Slot> old(std::max<std::size_t>(64, slots_.size() * 2));
    old.swap(slots_);
    const std::size_t mask = slots_.size() - 1;
    for (const Slot& s : old) {
      if (s.head < 0) continue;
      std::size_t i = hash(s.key) & mask;
      while (slots_[i].head >= 0) i = (i + 1) & mask;
      slots_[i] = s;
    }
  }
  const std::size_t mask = slots_.size() - 1;
  std::size_t i = hash(key) & mask;
  while (slots_[i].head >= 0 && !(slots_[i].key == key)) i = (i + 1) & mask;
  if (slots_[i].head < 0) ++used_, slots_[i].key = key;
  return slots_[i];
}

void IrradianceCache::include_in_root(const Key& key) {
  if (!has_root_) {
    root_ = key, has_root_ = true;
    return;
  }
  Key a = root_, b = key;
  const auto parent = [](Key k) {
    // Indices are never negative: the lattice starts at -1e7.
    return Key{k.x >> 1, k.y >> 1, k.z >> 1, static_cast<std::int16_t>(k.level + 1), k.depth};
  };
  while (a.level < b.level) a = parent(a);
  while (b.level < a.level) b = parent(b);
  while (a.x != b.x || a.y != b.y || a.z != b.z) a = parent(a), b = parent(b);
  root_ = a;
}

void IrradianceCache::clear_keep_settings() { *this = IrradianceCache(error_bound_); }

void IrradianceCache::add(const IrradianceSample& sample) {
  const double shrink = sample.depth == 0 ? 1.0 : 8.0;
  const double reach = static_cast<double>(sample.mean_distance) * error_bound_ * std::ldexp(1.0, sample.depth) / shrink;
  const Vec3& p = sample.point;
  if (!(reach > 0.0) || !std::isfinite(reach) || !std::isfinite(p.x + p.y + p.z)) return;
  // The largest power of two that is not above the diameter.
  int level = static_cast<int>(std::floor(std::log2(static_cast<float>(2.0 * reach))));
  const double farthest = std::max({std::fabs(p.x - reach), std::fabs(p.y - reach), std::fabs(p.z - reach)}) + kOrigin;
  while (farthest / std::ldexp(1.0, level) > 1e9) ++level;
  Key key;
  for (;; ++level) {
    const double side = std::ldexp(1.0, level);
    const double cell[3] = {std::floor((p.x + kOrigin) / side), std::floor((p.y + kOrigin) / side), std::floor((p.z + kOrigin) / side)};
    bool fits = true;
    for (int a = 0; a < 3; ++a) {
      const double centre = (cell[a] + 0.5) * side - kOrigin;
      fits &= p[a] - reach > centre - side && p[a] + reach < centre + side;
    }
    key = {static_cast<std::int32_t>(cell[0]), static_cast<std::int32_t>(cell[1]), static_cast<std::int32_t>(cell[2]),
           static_cast<std::int16_t>(level), sample.depth};
    if (fits || level > 60) break;
  }
  const auto index = static_cast<std::int32_t>(samples_.size());
  samples_.push_back(sample);
  Slot& cell = slot(key);
  next_.push_back(cell.head);
  cell.head = index;
  if (static_cast<int>(levels_.size()) <= sample.depth) levels_.resize(sample.depth + 1);
  auto& levels = levels_[sample.depth];
  if (std::find(levels.begin(), levels.end(), level) == levels.end()) levels.push_back(level);
  include_in_root(key);
}

}  // namespace verisim::global
