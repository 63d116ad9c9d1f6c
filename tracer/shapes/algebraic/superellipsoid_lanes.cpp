#include "tracer/shapes/algebraic/superellipsoid_lanes.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "tracer/simd/instruction_sets.h"

namespace verisim::shapes {
namespace {

constexpr double kZero = 1e-10;  // of the value

#define VERISIM_KERNELS "tracer/shapes/algebraic/superellipsoid_lanes.inc"
#include "tracer/simd/each_instruction_set.inc"

const SuperellipsoidKernels* const kAll[simd::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const SuperellipsoidKernels* superellipsoid_kernels(int set) {
  return set <= simd::best_instruction_set() ? kAll[set] : nullptr;
}

const SuperellipsoidKernels& superellipsoid_kernels() {
  static const SuperellipsoidKernels& best = *kAll[simd::best_instruction_set()];
  return best;
}

}  // namespace verisim::shapes
