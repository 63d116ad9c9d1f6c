#include "tracer/functions/program_lanes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "tracer/functions/library_tables.h"
#include "tracer/math/ray_row.h"
#include "tracer/simd/instruction_sets.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif
#define VERISIM_INLINE_LAMBDA __attribute__((always_inline))

namespace verisim::functions {
namespace {

#define VERISIM_KERNELS "tracer/functions/program_lanes.inc"
#include "tracer/simd/each_instruction_set.inc"

const LaneKernels* const kAll[simd::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const LaneKernels* lane_kernels(int set) { return set <= simd::best_instruction_set() ? kAll[set] : nullptr; }

const LaneKernels& lane_kernels() {
  static const LaneKernels& best = *kAll[simd::best_instruction_set()];
  return best;
}

}  // namespace verisim::functions
