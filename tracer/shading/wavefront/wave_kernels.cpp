#include "tracer/shading/wavefront/wave_kernels.h"

#include <bit>
#include <cmath>

#include "tracer/simd/instruction_sets.h"

namespace verisim::shading {
namespace {

using simd::InstructionSet;

constexpr float kDark = static_cast<float>(kEpsilon);

constexpr int rounded(int count) { return (count + WaveLanes::kStep - 1) / WaveLanes::kStep * WaveLanes::kStep; }

#define VERISIM_KERNELS "tracer/shading/wavefront/wave_kernels.inc"
#include "tracer/simd/each_instruction_set.inc"

const WaveKernels* const kAll[simd::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const WaveKernels* wave_kernels(int set) { return set <= simd::best_instruction_set() ? kAll[set] : nullptr; }

const WaveKernels& wave_kernels() {
  static const WaveKernels& best = *kAll[simd::best_instruction_set()];
  return best;
}

}  // namespace verisim::shading
