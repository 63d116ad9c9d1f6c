#include "tracer/shading/wave_kernels.h"

#include <bit>
#include <cmath>

#include "tracer/textures/instruction_sets.h"

namespace verisim::shading {
namespace {

using textures::InstructionSet;

constexpr int rounded(int count) { return (count + WaveLanes::kStep - 1) / WaveLanes::kStep * WaveLanes::kStep; }

namespace baseline {
#include "tracer/shading/wave_kernels.inc"
}  // namespace baseline

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,bmi2")
namespace avx2 {
#include "tracer/shading/wave_kernels.inc"
}  // namespace avx2
#pragma GCC target("avx2,bmi2,avx512f,avx512dq,avx512vl,avx512bw,prefer-vector-width=512")
namespace avx512 {
#include "tracer/shading/wave_kernels.inc"
}  // namespace avx512
#pragma GCC pop_options

const WaveKernels* const kAll[textures::kInstructionSets] = {&baseline::kKernels, &avx2::kKernels, &avx512::kKernels};
#else
const WaveKernels* const kAll[textures::kInstructionSets] = {&baseline::kKernels, nullptr, nullptr};
#endif

}  // namespace

const WaveKernels* wave_kernels(int set) { return set <= textures::best_instruction_set() ? kAll[set] : nullptr; }

const WaveKernels& wave_kernels() {
  static const WaveKernels& best = *kAll[textures::best_instruction_set()];
  return best;
}

}  // namespace verisim::shading
