#include "tracer/shapes/heights/height_grid.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "tracer/shapes/shared_payload.h"

namespace verisim::shapes {

std::shared_ptr<const HeightGrid> HeightGrid::of(const std::shared_ptr<const scene::HeightField>& field) {
  return shared_payload<HeightGrid>(field, [&] { return std::make_shared<HeightGrid>(*field); });
}

HeightGrid::Limits HeightGrid::limits(const scene::HeightField& field) {
  const scene::HeightMap none, &map = field.map ? *field.map : none;
  return {std::max<double>(map.lowest, field.water_level * 65536) - 0.001, map.highest + 0.001};
}

HeightGrid::Cells HeightGrid::cells(const scene::HeightField& field) {
  const auto between = [](int heights) { return std::max(heights - 1.0, 1.0); };
  return field.map ? Cells{between(field.map->width), between(field.map->depth)} : Cells{1, 1};
}

HeightGrid::HeightGrid(const scene::HeightField& field)
    : map_(field.map), water_(field.water_level * 65536), limits_(limits(field)) {
  if (!map_) return;
  width_ = map_->width, depth_ = map_->depth, heights_ = map_->heights.data();
  if (empty()) return;
  build_pyramid();
  build_search_blocks();
  smooth_ = field.smooth;
  if (smooth_) normals_.reset(static_cast<std::uint64_t*>(std::calloc(map_->heights.size(), sizeof(std::uint64_t))));
}

// Extremes of the cells of one row, from the heights below and above it.
void HeightGrid::batch_of_cells(int k, std::vector<std::uint16_t>& low, std::vector<std::uint16_t>& high) const {
  const std::uint16_t* below = &heights_[static_cast<std::size_t>(k) * static_cast<std::size_t>(width_)];
  const std::uint16_t* above = below + width_;
  std::uint16_t *lowest = low.data(), *highest = high.data();
  for (int i = 0; i + 1 < width_; ++i) {
    lowest[i] = std::min(std::min(below[i], below[i + 1]), std::min(above[i], above[i + 1]));
    highest[i] = std::max(std::max(below[i], below[i + 1]), std::max(above[i], above[i + 1]));
  }
}

HeightGrid::Level HeightGrid::blocks_of_cells() const {
  const int w = width_ - 1, d = depth_ - 1;
  Level level(w, d);
  // Beyond the edge of the field stays what no height is.
  const auto padded = static_cast<std::size_t>(4 * level.width);
  std::vector<std::uint16_t> low[4], high[4];
  for (int j = 0; j < 4; ++j) low[j].assign(padded, 65535), high[j].assign(padded, 0);
  Block* b = level.blocks.data();
  for (int k = 0; k < level.depth; ++k) {
    for (int j = 0; j < 4; ++j) {
      if (4 * k + j < d)
        batch_of_cells(4 * k + j, low[j], high[j]);
      else
        low[j].assign(padded, 65535), high[j].assign(padded, 0);
    }
    for (int i = 0; i < level.width; ++i, ++b) {
      for (int c = 0; c < kChildren; ++c) {
        const auto x = static_cast<std::size_t>(4 * i + column(c));
        b->low[c] = low[row(c)][x], b->high[c] = high[row(c)][x];
      }
    }
  }
  return level;
}

HeightGrid::Level HeightGrid::blocks_of_blocks(const Level& below) {
  Level level(below.width, below.depth);
  std::size_t n = 0;
  for (int k = 0; k < level.depth; ++k) {
    for (int i = 0; i < level.width; ++i) {
      Block& b = level.blocks[n++];
      for (int c = 0; c < kChildren; ++c) {
        const int x = 4 * i + column(c), z = 4 * k + row(c);
        b.low[c] = 65535, b.high[c] = 0;
        if (x >= below.width || z >= below.depth) continue;
        const Block& child = below.blocks[static_cast<std::size_t>(z) * static_cast<std::size_t>(below.width) +
                                          static_cast<std::size_t>(x)];
        b.low[c] = *std::min_element(child.low, child.low + kChildren);
        b.high[c] = *std::max_element(child.high, child.high + kChildren);
      }
    }
  }
  return level;
}

void HeightGrid::build_pyramid() {
  levels_.emplace_back();  // level 0 is the heights themselves
  levels_.push_back(blocks_of_cells());
  while (levels_.back().width > 1 || levels_.back().depth > 1) levels_.push_back(blocks_of_blocks(levels_.back()));
}

HeightGrid::SearchBlock HeightGrid::block_between(int i0, int i1, int k0, int k1) const {
  std::uint16_t low = 65535, high = 0;
  for (int k = k0; k <= k1; ++k) {
    const std::uint16_t* const row = &heights_[static_cast<std::size_t>(k) * static_cast<std::size_t>(width_)];
    for (int i = i0; i <= i1; ++i) low = std::min(low, row[i]), high = std::max(high, row[i]);
  }
  return {double(i0), double(i1), double(k0), double(k1), low, high};
}

// Some square root of n blocks along n cells (spec 04 5.2).
void HeightGrid::build_search_blocks() {
  const auto cells_of_block = [](int n) { return n / std::max(1, static_cast<int>(std::sqrt(n - 1.0))) + 1; };
  const int w = width_ - 1, d = depth_ - 1;
  search_width_ = cells_of_block(w), search_depth_ = cells_of_block(d), search_across_ = (w - 1) / search_width_ + 1;
  for (int k = 0; k < d; k += search_depth_)
    for (int i = 0; i < w; i += search_width_)
      search_blocks_.push_back(block_between(i, std::min(i + search_width_, w), k, std::min(k + search_depth_, d)));
}

Vec3 HeightGrid::smooth_normal(int i, int k) const {
  if (!normals_) return normal_from_heights(i, k);
  constexpr std::uint64_t kKnown = std::uint64_t{1} << 48;
  const auto component = [](std::uint64_t bits) { return static_cast<double>(static_cast<std::int16_t>(bits)); };
  const auto bits = [](double v) { return std::uint64_t{static_cast<std::uint16_t>(static_cast<std::int16_t>(v))}; };
  // Threads that compute the same normal write the same number.
  const std::atomic_ref<std::uint64_t> kept(
      normals_[static_cast<std::size_t>(k) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(i)]);
  std::uint64_t known = kept.load(std::memory_order_relaxed);
  if (known == 0) {
    const Vec3 n = normal_from_heights(i, k);
    known = bits(n.x) | bits(n.y) << 16 | bits(n.z) << 32 | kKnown;
    kept.store(known, std::memory_order_relaxed);
  }
  return {component(known), component(known >> 16), component(known >> 32)};
}

Vec3 HeightGrid::normal_from_heights(int i, int k) const {
  constexpr int kQuadrants[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  const double h = at(i, k);
  Vec3 sum(0, 0, 0);
  for (const auto& [dx, dz] : kQuadrants) {
    if (i + dx < 0 || i + dx >= width_ || k + dz < 0 || k + dz >= depth_) continue;
    sum += normalize(Vec3((h - at(i + dx, k)) * dx, 1, (h - at(i, k + dz)) * dz));
  }
  const double size = length(sum);
  const Vec3 n = size < kEpsilon ? Vec3(0, 1, 0) : sum / size;
  return {std::trunc(32767 * n.x), std::trunc(32767 * n.y), std::trunc(32767 * n.z)};
}

}  // namespace verisim::shapes
