#include "tracer/accel/row_kernels.h"

#include <cmath>

#include "tracer/shapes/plane.h"
#include "tracer/textures/instruction_sets.h"

namespace verisim::accel {
namespace {

namespace baseline {
#include "tracer/accel/row_kernels.inc"
}  // namespace baseline

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,bmi2")
namespace avx2 {
#include "tracer/accel/row_kernels.inc"
}  // namespace avx2
#pragma GCC target("avx2,bmi2,avx512f,avx512dq,avx512vl,avx512bw,prefer-vector-width=512")
namespace avx512 {
#include "tracer/accel/row_kernels.inc"
}  // namespace avx512
#pragma GCC pop_options

const RowKernels* const kAll[textures::kInstructionSets] = {&baseline::kKernels, &avx2::kKernels, &avx512::kKernels};
#else
const RowKernels* const kAll[textures::kInstructionSets] = {&baseline::kKernels, nullptr, nullptr};
#endif

}  // namespace

const RowKernels* row_kernels(int set) { return set <= textures::best_instruction_set() ? kAll[set] : nullptr; }

const RowKernels& row_kernels() {
  static const RowKernels& best = *kAll[textures::best_instruction_set()];
  return best;
}

}  // namespace verisim::accel
