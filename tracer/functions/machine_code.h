// Native code for a function's program (x86-64, System V). The same IEEE operations and the same C library functions as
// the interpreter of program.cpp, so the results are the same bits; only the dispatch is gone.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "tracer/functions/program.h"

namespace verisim::functions {

class MachineCode {
 public:
  // Null where native code cannot be made: another processor, executable memory refused, a very long program.
  static std::shared_ptr<const MachineCode> translate(const std::vector<Instruction>& code,
                                                      const std::vector<Call>& calls, std::uint32_t first_constant,
                                                      std::span<const double> constants, std::uint32_t result);
  ~MachineCode();
  MachineCode(const MachineCode&) = delete;
  MachineCode& operator=(const MachineCode&) = delete;

  // `registers` holds the parameters at its beginning; the rest is scratch.
  double run(double* registers) const { return entry_(registers); }

 private:
  MachineCode() = default;
  using Entry = double (*)(double*);
  Entry entry_ = nullptr;
  void* memory_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace verisim::functions
