// The blocks a render area is cut into, in the order they are worked on (spec 02 section 3.1).
#pragma once

#include <span>
#include <vector>

#include "tracer/render/sampling/antialias.h"

namespace verisim::render {

struct Area {
  int x, y, width, height;
  bool empty() const { return width <= 0 || height <= 0; }
};

// The part of the image that is to be rendered; clipped to the image.
Area render_area(const Options& options);
// Squares of options.block_size from the area's top left corner, row by row; those at the right and bottom edge are
// clipped.
std::vector<Block> blocks_of(const Area& area, int block_size);
// Which of `parts` parts each of these blocks of an area belongs to, from 0: in turn along a Z-curve, so that every
// part has blocks from everywhere in the picture, and all take about the same time.
std::vector<int> parts_of(std::span<const Block> blocks, int parts);
// Where the blocks of a part lie in its framebuffer: below one another, each at the left.
std::vector<Block> strip_of(std::span<const Block> blocks_of_part);

}  // namespace verisim::render
