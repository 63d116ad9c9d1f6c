#include "tracer/shapes/swept/sphere_sweep_lanes.h"

#include "tracer/simd/instruction_sets.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // vectors are only passed between functions that are inlined

namespace verisim::shapes {
namespace {

#define VERISIM_KERNELS "tracer/shapes/swept/sphere_sweep_lanes.inc"
#include "tracer/simd/each_instruction_set.inc"

const SweepFollow* const kAll[textures::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

SweepFollow sweep_follow(int set) { return set <= textures::best_instruction_set() ? *kAll[set] : nullptr; }

SweepFollow sweep_follow() { return *kAll[textures::best_instruction_set()]; }

}  // namespace verisim::shapes
