#include "tracer/shapes/lane_kernels.h"

#include <cmath>

#include "tracer/simd/instruction_sets.h"

namespace verisim::shapes {
namespace {

#define VERISIM_KERNELS "tracer/shapes/lane_kernels.inc"
#include "tracer/simd/each_instruction_set.inc"

const LaneKernels* const kAll[simd::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const LaneKernels* lane_kernels(int set) { return set <= simd::best_instruction_set() ? kAll[set] : nullptr; }

const LaneKernels& lane_kernels() {
  static const LaneKernels& best = *kAll[simd::best_instruction_set()];
  return best;
}

}  // namespace verisim::shapes
