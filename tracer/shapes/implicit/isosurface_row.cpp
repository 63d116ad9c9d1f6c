#include "tracer/shapes/implicit/isosurface_row.h"

#include <algorithm>

#include "tracer/functions/program_lanes.h"

namespace verisim::shapes {

const functions::Program* FieldLanes::suitable(const Function* function) {
  const auto* program = dynamic_cast<const functions::Program*>(function);
  return program && !program->has_jumps() && program->parameters() == 3 && program->registers() <= kMostRegisters
             ? program
             : nullptr;
}

// Lanes that are not asked for are computed with the others, and must not be slow.
static void prepare(const functions::Program& program, double* registers, std::size_t width) {
  std::fill_n(registers, 3 * width, 0.0);
  for (const functions::Call& call : program.calls())
    std::fill_n(registers + call.results * width, static_cast<std::size_t>(call.function->components()) * width, 0.0);
  program.set_constants(registers, width);
}

FieldLanes::FieldLanes(const functions::Program& program) : program_(program) {
  prepare(program, registers_, SearchLanes::kCount);
}

const double* FieldLanes::evaluate(unsigned asked, bool nearly) {
  const functions::LaneKernels& kernels = functions::lane_kernels();
  (nearly ? kernels.nearly : kernels.narrow)(program_.code(), program_.calls(), registers_, asked);
  return registers_ + program_.result_register() * SearchLanes::kCount;
}

void evaluate_around(const functions::Program& program, const double (&points)[3][SearchLanes::kCount], double step,
                     unsigned asked, double* values) {
  constexpr int kLanes = SearchLanes::kCount, kBroad = functions::LaneKernels::kBroad;
  static_assert(kBroad == 4 * kLanes);
  constexpr std::size_t kFew = 64;  // registers
  const auto coordinate = [&](int axis, int n, int k) {
    return n == axis + 1 ? points[axis][k] + step : points[axis][k];
  };
  if (program.registers() > kFew) {
    FieldLanes field(program);
    for (int n = 0; n < 4; ++n) {
      for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < kLanes; ++k) field.points()[axis * kLanes + k] = coordinate(axis, n, k);
      std::copy_n(field.evaluate(asked, false), kLanes, values + n * kLanes);
    }
    return;
  }
  // Together, because one would wait for the results of its instructions.
  alignas(64) double registers[kFew * kBroad];
  prepare(program, registers, kBroad);
  for (int axis = 0; axis < 3; ++axis)
    for (int n = 0; n < 4; ++n)
      for (int k = 0; k < kLanes; ++k) registers[axis * kBroad + n * kLanes + k] = coordinate(axis, n, k);
  functions::lane_kernels().broad(program.code(), program.calls(), registers, asked * std::uint64_t{0x01010101});
  std::copy_n(registers + program.result_register() * kBroad, kBroad, values);
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
