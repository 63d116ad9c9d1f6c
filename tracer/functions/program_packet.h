// Programs run for several points at once. Compiled for several instruction sets; all give the bits that the
// interpreter gives for one point.
#pragma once

#include <cstdint>
#include <span>

#include "tracer/functions/program.h"

namespace verisim::functions {

struct ProgramKernels {
  static constexpr int kNarrow = 8, kBroad = 32, kWide = 64;
  // Runs a program without jumps. Register k of point i is registers[k * width + i]; aligned to 64 bytes. Only what is
  // asked for has a meaning afterwards.
  void (*narrow)(std::span<const Instruction> code, std::span<const Call> calls, double* registers,
                 std::uint64_t active);
  // The same, but for sines and cosines, which are within kApproximateError of the library's for numbers up to
  // kMaxApproximate, and for angles, which always are.
  static constexpr double kApproximateError = 0x1p-49, kMaxApproximate = 1e5;
  void (*approximate)(std::span<const Instruction> code, std::span<const Call> calls, double* registers,
                      std::uint64_t active);
  void (*broad)(std::span<const Instruction> code, std::span<const Call> calls, double* registers,
                std::uint64_t active);
  void (*wide)(std::span<const Instruction> code, std::span<const Call> calls, double* registers, std::uint64_t active);
};

// Those of the best instruction set of this machine.
const ProgramKernels& packet_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const ProgramKernels* packet_kernels(int instruction_set);

}  // namespace verisim::functions
