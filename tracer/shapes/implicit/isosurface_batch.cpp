#include "tracer/shapes/implicit/isosurface_batch.h"

#include <algorithm>

#include "tracer/functions/program_packet.h"

namespace verisim::shapes {

const functions::Program* FieldPacket::suitable(const Function* function) {
  const auto* program = dynamic_cast<const functions::Program*>(function);
  return program && !program->has_jumps() && program->parameters() == 3 && program->registers() <= kMaxRegisters
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

FieldPacket::FieldPacket(const functions::Program& program) : program_(program) {
  prepare(program, registers_, SearchPacket::kCount);
}

const double* FieldPacket::evaluate(unsigned active_mask, bool approximate) {
  const functions::ProgramKernels& kernels = functions::packet_kernels();
  (approximate ? kernels.approximate : kernels.narrow)(program_.code(), program_.calls(), registers_, active_mask);
  return registers_ + program_.result_register() * SearchPacket::kCount;
}

void evaluate_around(const functions::Program& program, const double (&points)[3][SearchPacket::kCount], double step,
                     unsigned active_mask, double* values) {
  constexpr int kLanes = SearchPacket::kCount, kBroad = functions::ProgramKernels::kBroad;
  static_assert(kBroad == 4 * kLanes);
  constexpr std::size_t kFew = 64;  // registers
  const auto coordinate = [&](int axis, int n, int k) {
    return n == axis + 1 ? points[axis][k] + step : points[axis][k];
  };
  if (program.registers() > kFew) {
    FieldPacket field(program);
    for (int n = 0; n < 4; ++n) {
      for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < kLanes; ++k) field.points()[axis * kLanes + k] = coordinate(axis, n, k);
      std::copy_n(field.evaluate(active_mask, false), kLanes, values + n * kLanes);
    }
    return;
  }
  // Together, because one would wait for the results of its instructions.
  alignas(64) double registers[kFew * kBroad];
  prepare(program, registers, kBroad);
  for (int axis = 0; axis < 3; ++axis)
    for (int n = 0; n < 4; ++n)
      for (int k = 0; k < kLanes; ++k) registers[axis * kBroad + n * kLanes + k] = coordinate(axis, n, k);
  functions::packet_kernels().broad(program.code(), program.calls(), registers,
                                    active_mask * std::uint64_t{0x01010101});
  std::copy_n(registers + program.result_register() * kBroad, kBroad, values);
}

unsigned find_intersections(FieldPacket& field, SearchPacket& packet, unsigned active_mask) {
  const IsosurfaceKernels& kernels = isosurface_kernels();
  unsigned active = kernels.start(packet, active_mask);
  while (active != 0) {
    kernels.middles(packet, field.points());
    active = kernels.advance(packet, field.evaluate(active, packet.doubt > 0));
  }
  unsigned found = 0;
  each_lane(active_mask, [&](int k) { found |= packet.found[k] != 0 ? 1u << k : 0; });
  return found;
}

}  // namespace verisim::shapes
