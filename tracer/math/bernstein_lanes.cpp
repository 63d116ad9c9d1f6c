#include "tracer/math/bernstein_lanes.h"

#include <cmath>

#include "tracer/simd/instruction_sets.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // vectors are only passed between functions that are inlined

namespace verisim {
namespace {

#define VERISIM_KERNELS "tracer/math/bernstein_lanes.inc"
#include "tracer/simd/each_instruction_set.inc"

const BernsteinKernels* const kAll[textures::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const BernsteinKernels* bernstein_kernels(int set) {
  return set <= textures::best_instruction_set() ? kAll[set] : nullptr;
}

const BernsteinKernels& bernstein_kernels() {
  static const BernsteinKernels& best = *kAll[textures::best_instruction_set()];
  return best;
}

}  // namespace verisim
