#include "tracer/textures/normals/normal_kernels.h"

#include <cmath>

namespace verisim::textures {
namespace {

constexpr int rounded(int count) { return (count + 7) / 8 * 8; }

#define VERISIM_KERNELS "tracer/textures/normals/normal_kernels.inc"
#include "tracer/simd/each_instruction_set.inc"

const NormalKernels* const kAll[simd::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const NormalKernels& normal_kernels(simd::InstructionSet set) { return *kAll[set]; }

}  // namespace verisim::textures
