#include "tracer/shapes/lane_kernels.h"

#include <cmath>

#include "tracer/textures/instruction_sets.h"

namespace verisim::shapes {
namespace {

namespace baseline {
#include "tracer/shapes/lane_kernels.inc"
}  // namespace baseline

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,bmi2")
namespace avx2 {
#include "tracer/shapes/lane_kernels.inc"
}  // namespace avx2
#pragma GCC target("avx2,bmi2,avx512f,avx512dq,avx512vl,avx512bw,prefer-vector-width=512")
namespace avx512 {
#include "tracer/shapes/lane_kernels.inc"
}  // namespace avx512
#pragma GCC pop_options

const LaneKernels* const kAll[textures::kInstructionSets] = {&baseline::kKernels, &avx2::kKernels, &avx512::kKernels};
#else
const LaneKernels* const kAll[textures::kInstructionSets] = {&baseline::kKernels, nullptr, nullptr};
#endif

}  // namespace

const LaneKernels* lane_kernels(int set) { return set <= textures::best_instruction_set() ? kAll[set] : nullptr; }

const LaneKernels& lane_kernels() {
  static const LaneKernels& best = *kAll[textures::best_instruction_set()];
  return best;
}

}  // namespace verisim::shapes
