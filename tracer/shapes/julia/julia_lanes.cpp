#include "tracer/shapes/julia/julia_lanes.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "tracer/functions/library_tables.h"
#include "tracer/simd/instruction_sets.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif
#define VERISIM_INLINE_LAMBDA __attribute__((always_inline))

namespace verisim::shapes::julia {
namespace {

#define VERISIM_KERNELS "tracer/shapes/julia/julia_lanes.inc"
#include "tracer/simd/each_instruction_set.inc"

const Kernels* const kSets[simd::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const Kernels* kernels(int set) { return set <= simd::best_instruction_set() ? kSets[set] : nullptr; }

const Kernels& kernels() {
  static const Kernels& best = *kSets[simd::best_instruction_set()];
  return best;
}

}  // namespace verisim::shapes::julia
