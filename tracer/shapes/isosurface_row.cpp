#include "tracer/shapes/isosurface_row.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "tracer/functions/program_lanes.h"
#include "tracer/textures/instruction_sets.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace verisim::shapes {
namespace {

#define VERISIM_KERNELS "tracer/shapes/isosurface_row.inc"
#include "tracer/textures/each_instruction_set.inc"

const IsosurfaceKernels* const kAll[textures::kInstructionSets] = VERISIM_KERNEL_TABLES;

}  // namespace

const IsosurfaceKernels* isosurface_kernels(int set) { return set <= textures::best_instruction_set() ? kAll[set] : nullptr; }

const IsosurfaceKernels& isosurface_kernels() {
  static const IsosurfaceKernels& best = *kAll[textures::best_instruction_set()];
  return best;
}

const functions::Program* FieldLanes::suitable(const Function* function) {
  const auto* program = dynamic_cast<const functions::Program*>(function);
  return program && !program->has_jumps() && program->parameters() == 3 && program->registers() <= kMostRegisters ? program : nullptr;
}

FieldLanes::FieldLanes(const functions::Program& program) : program_(program) {
  constexpr std::size_t kCount = SearchLanes::kCount;
  // Lanes that are not asked for are computed with the others, and must not be slow.
  std::fill_n(registers_, 3 * kCount, 0.0);
  for (const functions::Call& call : program.calls()) std::fill_n(registers_ + call.results * kCount, static_cast<std::size_t>(call.function->components()) * kCount, 0.0);
  program.set_constants(registers_, kCount);
}

const double* FieldLanes::evaluate(unsigned asked, bool nearly) {
  const functions::LaneKernels& kernels = functions::lane_kernels();
  (nearly ? kernels.nearly : kernels.narrow)(program_.code(), program_.calls(), registers_, asked);
  return registers_ + program_.result_register() * SearchLanes::kCount;
}

unsigned find_crossings(FieldLanes& field, SearchLanes& lanes, unsigned asked) {
  const IsosurfaceKernels& kernels = isosurface_kernels();
  unsigned active = kernels.start(lanes, asked);
  while (active != 0) {
    kernels.middles(lanes, field.points());
    active = kernels.advance(lanes, field.evaluate(active, lanes.doubt > 0));
  }
  unsigned found = 0;
  each_lane(asked, [&](int k) { found |= lanes.found[k] != 0 ? 1u << k : 0; });
  return found;
}

}  // namespace verisim::shapes
