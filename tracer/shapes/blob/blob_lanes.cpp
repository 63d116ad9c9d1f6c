#include "tracer/shapes/blob/blob_lanes.h"

#include <cmath>

#include "tracer/simd/instruction_sets.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // vectors are only passed between functions that are inlined

namespace verisim::shapes {
namespace {

#define VERISIM_KERNELS "tracer/shapes/blob/blob_lanes.inc"
#include "tracer/simd/each_instruction_set.inc"

const BlobKernels* const kAll[textures::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const BlobKernels* blob_kernels(int set) { return set <= textures::best_instruction_set() ? kAll[set] : nullptr; }

const BlobKernels& blob_kernels() {
  static const BlobKernels& best = *kAll[textures::best_instruction_set()];
  return best;
}

}  // namespace verisim::shapes
