#include "tracer/textures/patterns/crackle_kernels.h"

#include <bit>
#include <cmath>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#define VERISIM_INLINE inline __attribute__((always_inline))
#pragma GCC diagnostic ignored "-Wpsabi"          // vectors are only passed between functions that are inlined
#pragma GCC diagnostic ignored "-Wuninitialized"  // GCC 12 reports its own intrinsics
#pragma GCC diagnostic ignored "-Wunused-function"

namespace verisim::textures {
namespace {

namespace baseline {
#define VERISIM_REGISTER_DOUBLES 2
#include "tracer/noise/noise_lanes.inc"
#include "tracer/textures/patterns/crackle_kernels.inc"
#undef VERISIM_REGISTER_DOUBLES
}  // namespace baseline

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,bmi2")
namespace avx2 {
#define VERISIM_REGISTER_DOUBLES 4
#include "tracer/noise/noise_lanes.inc"
#include "tracer/textures/patterns/crackle_kernels.inc"
#undef VERISIM_REGISTER_DOUBLES
}  // namespace avx2
#pragma GCC target("avx2,bmi2,avx512f,avx512dq,avx512vl,avx512bw")
namespace avx512 {
#define VERISIM_REGISTER_DOUBLES 8
#include "tracer/noise/noise_lanes.inc"
#include "tracer/textures/patterns/crackle_kernels.inc"
#undef VERISIM_REGISTER_DOUBLES
}  // namespace avx512
#pragma GCC pop_options

const CrackleKernels* const kAll[simd::kInstructionSets] = {&baseline::kKernels, &baseline::kKernels, &avx2::kKernels, &avx512::kKernels};
#else
const CrackleKernels* const kAll[simd::kInstructionSets] = {&baseline::kKernels, &baseline::kKernels,
                                                            &baseline::kKernels, &baseline::kKernels};
#endif

}  // namespace

const CrackleKernels& crackle_kernels(simd::InstructionSet set) { return *kAll[set]; }

}  // namespace verisim::textures
