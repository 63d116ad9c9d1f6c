#include "tracer/shapes/superellipsoid_lanes.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "tracer/textures/instruction_sets.h"

namespace verisim::shapes {
namespace {

constexpr double kZero = 1e-10;  // of the value

namespace baseline {
#include "tracer/shapes/superellipsoid_lanes.inc"
}  // namespace baseline

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,bmi2")
namespace avx2 {
#include "tracer/shapes/superellipsoid_lanes.inc"
}  // namespace avx2
#pragma GCC target("avx2,bmi2,avx512f,avx512dq,avx512vl,avx512bw,prefer-vector-width=512")
namespace avx512 {
#include "tracer/shapes/superellipsoid_lanes.inc"
}  // namespace avx512
#pragma GCC pop_options

const SuperellipsoidKernels* const kAll[textures::kInstructionSets] = {&baseline::kKernels, &avx2::kKernels, &avx512::kKernels};
#else
const SuperellipsoidKernels* const kAll[textures::kInstructionSets] = {&baseline::kKernels, nullptr, nullptr};
#endif

}  // namespace

const SuperellipsoidKernels* superellipsoid_kernels(int set) { return set <= textures::best_instruction_set() ? kAll[set] : nullptr; }

const SuperellipsoidKernels& superellipsoid_kernels() {
  static const SuperellipsoidKernels& best = *kAll[textures::best_instruction_set()];
  return best;
}

}  // namespace verisim::shapes
