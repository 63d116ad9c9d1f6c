// The choice between the versions of a kernel that each_target.h makes.
#pragma once

#include "tracer/simd/instruction_sets.h"

// The constants kKernels of all targets, by InstructionSet; null: not compiled here.
#define VERISIM_KERNEL_TABLE(kernels) \
  { &HWY_STATIC_DISPATCH(kernels), HWY_CHOOSE_SSE4(kernels), HWY_CHOOSE_AVX2(kernels), HWY_CHOOSE_AVX3(kernels) }

// Defines both functions `name` that give kernels: those of any instruction set, for tests (null: this machine cannot
// run them), and those of the best one.
#define VERISIM_EXPORT_KERNELS(Kernels, name) VERISIM_EXPORT_KERNELS_OF(Kernels, name, kKernels)
// The same of constants with another name.
#define VERISIM_EXPORT_KERNELS_OF(Kernels, name, kernels)                                         \
  const Kernels* name(int set) {                                                                  \
    static constexpr const Kernels* kAll[simd::kInstructionSets] = VERISIM_KERNEL_TABLE(kernels); \
    return set <= simd::best_instruction_set() ? kAll[set] : nullptr;                             \
  }                                                                                               \
  const Kernels& name() {                                                                         \
    static const Kernels& best = *name(simd::best_instruction_set());                             \
    return best;                                                                                  \
  }
