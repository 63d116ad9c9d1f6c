#include "tracer/radiosity/irradiance_lanes.h"

#include <bit>
#include <cmath>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "tracer/simd/instruction_sets.h"

namespace verisim::global {
namespace {

#define VERISIM_KERNELS "tracer/radiosity/irradiance_lanes.inc"
#include "tracer/simd/each_instruction_set.inc"

const IrradianceLaneKernels* const kAll[simd::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const IrradianceLaneKernels* irradiance_lane_kernels(int set) {
  return set <= simd::best_instruction_set() ? kAll[set] : nullptr;
}

const IrradianceLaneKernels& irradiance_lane_kernels() {
  static const IrradianceLaneKernels& best = *kAll[simd::best_instruction_set()];
  return best;
}

}  // namespace verisim::global
