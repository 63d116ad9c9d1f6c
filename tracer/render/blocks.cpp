#include "tracer/render/blocks.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace verisim::render {

Area render_area(const Options& o) {
  const int last_column = o.last_column < 0 ? o.width - 1 : std::min(o.last_column, o.width - 1);
  const int last_row = o.last_row < 0 ? o.height - 1 : std::min(o.last_row, o.height - 1);
  const int x = std::max(o.first_column, 0), y = std::max(o.first_row, 0);
  return {x, y, last_column - x + 1, last_row - y + 1};
}

std::vector<Block> blocks_of(const Area& area, int block_size) {
  std::vector<Block> blocks;
  if (area.empty()) return blocks;
  const int size = std::max(1, std::min(block_size, std::max(area.width, area.height)));
  for (int y = 0; y < area.height; y += size)
    for (int x = 0; x < area.width; x += size)
      blocks.push_back({area.x + x, area.y + y, std::min(size, area.width - x), std::min(size, area.height - y)});
  return blocks;
}

std::vector<int> parts_of(std::span<const Block> blocks, int parts) {
  std::vector<std::pair<std::uint64_t, std::size_t>> curve;  // place on the curve (Morton, 1966), number of the block
  curve.reserve(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    // The first block is as large as any.
    const auto column = static_cast<std::uint32_t>((blocks[i].x - blocks[0].x) / blocks[0].width),
               row = static_cast<std::uint32_t>((blocks[i].y - blocks[0].y) / blocks[0].height);
    std::uint64_t place = 0;
    for (int bit = 0; bit < 32; ++bit)
      place |= (std::uint64_t{column} >> bit & 1) << 2 * bit | (std::uint64_t{row} >> bit & 1) << (2 * bit + 1);
    curve.emplace_back(place, i);
  }
  std::sort(curve.begin(), curve.end());
  std::vector<int> result(blocks.size());
  for (std::size_t i = 0; i < curve.size(); ++i)
    result[curve[i].second] = static_cast<int>(i % static_cast<std::size_t>(parts));
  return result;
}

std::vector<Block> strip_of(std::span<const Block> blocks_of_part) {
  std::vector<Block> strip;
  int y = 0;
  for (const Block& block : blocks_of_part)
    strip.push_back({0, std::exchange(y, y + block.height), block.width, block.height});
  return strip;
}

}  // namespace verisim::render
