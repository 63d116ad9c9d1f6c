#include "tracer/radiosity/irradiance_weights.h"

#include <cmath>

#include "tracer/simd/instruction_sets.h"

namespace verisim::global {
namespace {

#define VERISIM_KERNELS "tracer/radiosity/irradiance_weights.inc"
#include "tracer/simd/each_instruction_set.inc"

const IrradianceWeightKernels* const kAll[simd::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const IrradianceWeightKernels* irradiance_weight_kernels(int set) {
  return set <= simd::best_instruction_set() ? kAll[set] : nullptr;
}

const IrradianceWeightKernels& irradiance_weight_kernels() {
  static const IrradianceWeightKernels& best = *kAll[simd::best_instruction_set()];
  return best;
}

}  // namespace verisim::global
