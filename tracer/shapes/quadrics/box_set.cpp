#include "tracer/shapes/quadrics/box_set.h"

#include <algorithm>
#include <cmath>

namespace verisim::shapes {

BoxSet::BoxSet() : kernels_(&box_kernels()) {}

BoxSet::BoxSet(std::span<const Box3> boxes) : BoxSet() {
  Box3 all;
  for (const Box3& box : boxes) all.extendBy(box);
  blocks_.resize((boxes.size() + 7) / 8);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    all_ |= std::uint32_t{1} << i;
    EightBoxes& block = blocks_[i / 8];
    for (int axis = 0; axis < 3; ++axis) {
      const double slack =
          2e-6 * length(all.max - all.min) + 1e-9 * std::max(std::fabs(all.min[axis]), std::fabs(all.max[axis]));
      block.low[axis][i % 8] = boxes[i].min[axis] - slack, block.high[axis][i % 8] = boxes[i].max[axis] + slack;
    }
  }
}

}  // namespace verisim::shapes
