#include "tracer/world/row_kernels.h"

#include <cmath>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "tracer/shapes/quadrics/plane.h"
#include "tracer/simd/instruction_sets.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // vectors are only passed between functions that are inlined

namespace verisim::accel {
namespace {

#define VERISIM_KERNELS "tracer/world/row_kernels.inc"
#include "tracer/simd/each_instruction_set.inc"

const RowKernels* const kAll[textures::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const RowKernels* row_kernels(int set) { return set <= textures::best_instruction_set() ? kAll[set] : nullptr; }

const RowKernels& row_kernels() {
  static const RowKernels& best = *kAll[textures::best_instruction_set()];
  return best;
}

}  // namespace verisim::accel
