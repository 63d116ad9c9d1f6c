#include "tracer/media/media_kernels.h"

#include <cmath>

#include "tracer/simd/instruction_sets.h"

namespace verisim::global {
namespace {

constexpr int rounded(int count) { return (count + MediaLanes::kStep - 1) / MediaLanes::kStep * MediaLanes::kStep; }

#define VERISIM_KERNELS "tracer/media/media_kernels.inc"
#include "tracer/simd/each_instruction_set.inc"

const MediaKernels* const kAll[simd::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const MediaKernels* media_kernels(int set) { return set <= simd::best_instruction_set() ? kAll[set] : nullptr; }

const MediaKernels& media_kernels() {
  static const MediaKernels& best = *kAll[simd::best_instruction_set()];
  return best;
}

}  // namespace verisim::global
