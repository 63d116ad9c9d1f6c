// The fast noise and what is built upon it, compiled for several instruction sets. All versions do the same operations
// in the same order, and none may fuse products and sums, so all give the same bits.
//
// Not in packets of Highway's vectors (simd/packet-inl.h) as other kernels are: written so, GCC 12 compiled the AVX2
// version alone in 30 s of CPU and the baseline in 90 s, where all three sets take 72 s as they are here.
#include "tracer/noise/noise_kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <span>
#include <type_traits>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "hwy/base.h"
#include "tracer/functions/program_packet.h"
#include "tracer/textures/evaluation/evaluation.h"
#include "tracer/textures/evaluation/evaluation_faults.h"
#include "tracer/noise/noise_cells.h"
#include "tracer/textures/patterns/formulas.h"
#include "tracer/textures/patterns/fractal_kernels.h"

#define VERISIM_INLINE inline __attribute__((always_inline))
#define VERISIM_INLINE_LAMBDA __attribute__((always_inline))
#define VERISIM_RARE __attribute__((noinline))
#pragma GCC diagnostic ignored "-Wpsabi"          // vectors are only passed between functions that are inlined
#pragma GCC diagnostic ignored "-Wuninitialized"  // GCC 12 reports its own intrinsics

namespace verisim::textures {
namespace {

Octaves make_granite_octaves() {
  Octaves o(6, 2, 0.5);
  for (double& s : o.scale) s *= 4;
  o.farthest /= 4;
  return o;
}
const Octaves& granite_octaves() {
  static const Octaves octaves = make_granite_octaves();
  return octaves;
}
const Octaves& wrinkles_octaves() {
  static const Octaves octaves(10, 2, 0.5);
  return octaves;
}

namespace baseline {
#define VERISIM_INSTRUCTION_SET "baseline"
#define VERISIM_REGISTER_DOUBLES 2
#include "tracer/textures/evaluation/kernels_of_set.inc"
#undef VERISIM_REGISTER_DOUBLES
#undef VERISIM_INSTRUCTION_SET
}  // namespace baseline

#if defined(__x86_64__)
// Clang's attributes of a region pass over lambdas.
#undef VERISIM_INLINE_LAMBDA
#define VERISIM_INLINE_LAMBDA __attribute__((always_inline, target(VERISIM_TARGET)))
#define VERISIM_TARGET "avx2,bmi2"
HWY_PUSH_ATTRIBUTES(VERISIM_TARGET)
namespace avx2 {
#define VERISIM_INSTRUCTION_SET "avx2"
#define VERISIM_REGISTER_DOUBLES 4
#include "tracer/textures/evaluation/kernels_of_set.inc"
#undef VERISIM_REGISTER_DOUBLES
#undef VERISIM_INSTRUCTION_SET
}  // namespace avx2
HWY_POP_ATTRIBUTES
#undef VERISIM_TARGET
#define VERISIM_TARGET "avx2,bmi2,avx512f,avx512dq,avx512vl,avx512bw"
HWY_PUSH_ATTRIBUTES(VERISIM_TARGET)
namespace avx512 {
#define VERISIM_INSTRUCTION_SET "avx512"
#define VERISIM_REGISTER_DOUBLES 8
#include "tracer/textures/evaluation/kernels_of_set.inc"
#undef VERISIM_REGISTER_DOUBLES
#undef VERISIM_INSTRUCTION_SET
}  // namespace avx512
HWY_POP_ATTRIBUTES

const NoiseKernels* const kAll[simd::kInstructionSets] = {&baseline::kKernels, &baseline::kKernels, &avx2::kKernels,
                                                          &avx512::kKernels};
const EvaluationKernels* const kAllEvaluations[simd::kInstructionSets] = {
    &baseline::kEvaluation, &baseline::kEvaluation, &avx2::kEvaluation, &avx512::kEvaluation};
#else
const NoiseKernels* const kAll[simd::kInstructionSets] = {&baseline::kKernels, &baseline::kKernels, &baseline::kKernels,
                                                          &baseline::kKernels};
const EvaluationKernels* const kAllEvaluations[simd::kInstructionSets] = {
    &baseline::kEvaluation, &baseline::kEvaluation, &baseline::kEvaluation, &baseline::kEvaluation};
#endif

}  // namespace

const NoiseKernels& noise_kernels(simd::InstructionSet set) { return *kAll[set]; }
const EvaluationKernels& evaluation_kernels(simd::InstructionSet set) { return *kAllEvaluations[set]; }

}  // namespace verisim::textures
