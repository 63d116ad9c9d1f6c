#include "tracer/shapes/quadrics/box_set.h"

#include <algorithm>
#include <cmath>

#include "tracer/simd/instruction_sets.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // vectors are only passed between functions that are inlined

namespace verisim::shapes {
namespace {

#define VERISIM_KERNELS "tracer/shapes/quadrics/box_set.inc"
#include "tracer/simd/each_instruction_set.inc"

const BoxKernels* const kAll[textures::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const BoxKernels* box_kernels(int set) { return set <= textures::best_instruction_set() ? kAll[set] : nullptr; }

BoxSet::BoxSet() : kernels_(kAll[textures::best_instruction_set()]) {}

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
