#include "tracer/render/blocks.h"

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

}  // namespace verisim::render
