// Edges of a picture: where a difference may come from a sub-pixel shift rather than from wrong shading.
#pragma once

#include "compare/metrics/values.h"

namespace verisim::compare {

// 1 for pixels on or beside an edge: Sobel's gradient of the luma is at least that of a step of `step` (8-bit units),
// dilated by one pixel.
std::vector<unsigned char> edge_mask(const Values& picture, double step = 16);
// Of the rows from begin to end only; needs the two rows above and below them.
std::vector<unsigned char> edge_mask(const Values& picture, int begin, int end, double step = 16);

}  // namespace verisim::compare
