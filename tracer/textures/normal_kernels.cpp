#include "tracer/textures/normal_kernels.h"

#include <cmath>

namespace verisim::textures {
namespace {

constexpr int rounded(int count) { return (count + 7) / 8 * 8; }

namespace baseline {
#include "tracer/textures/normal_kernels.inc"
}  // namespace baseline

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,bmi2")
namespace avx2 {
#include "tracer/textures/normal_kernels.inc"
}  // namespace avx2
#pragma GCC target("avx2,bmi2,avx512f,avx512dq,avx512vl,avx512bw,prefer-vector-width=512")
namespace avx512 {
#include "tracer/textures/normal_kernels.inc"
}  // namespace avx512
#pragma GCC pop_options

const NormalKernels* const kAll[kInstructionSets] = {&baseline::kKernels, &avx2::kKernels, &avx512::kKernels};
#else
const NormalKernels* const kAll[kInstructionSets] = {&baseline::kKernels};
#endif

}  // namespace

const NormalKernels& normal_kernels(InstructionSet set) { return *kAll[set]; }

}  // namespace verisim::textures
