#include "tracer/shapes/algebraic/poly_lanes.h"

#include <algorithm>

#include "tracer/simd/instruction_sets.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // vectors are only passed between functions that are inlined

namespace verisim::shapes {
namespace {

#define VERISIM_KERNELS "tracer/shapes/algebraic/poly_lanes.inc"
#include "tracer/simd/each_instruction_set.inc"

const PolyAlong* const kAll[textures::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

PolyAlong poly_along(int set) { return set <= textures::best_instruction_set() ? *kAll[set] : nullptr; }

PolyAlong poly_along() { return *kAll[textures::best_instruction_set()]; }

}  // namespace verisim::shapes
