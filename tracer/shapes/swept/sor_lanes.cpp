#include "tracer/shapes/swept/sor_lanes.h"

#include <cmath>

#include "tracer/simd/instruction_sets.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // vectors are only passed between functions that are inlined

namespace verisim::shapes {
namespace {

#define VERISIM_KERNELS "tracer/shapes/swept/sor_lanes.inc"
#include "tracer/simd/each_instruction_set.inc"

const SorKernels* const kAll[textures::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const SorKernels* sor_kernels(int set) { return set <= textures::best_instruction_set() ? kAll[set] : nullptr; }

const SorKernels& sor_kernels() {
  static const SorKernels& best = *kAll[textures::best_instruction_set()];
  return best;
}

}  // namespace verisim::shapes
