// Native code for a function's program (x86-64, System V). The same IEEE operations and the same C library functions as
// the interpreter of program.cpp, so the results are the same bits; only the dispatch is gone.
#pragma once

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
  using Entry = double (*)(double*);
  class Translator;
  explicit MachineCode(std::unique_ptr<Translator> code);

  std::unique_ptr<Translator> code_;
  Entry entry_ = nullptr;
};

}  // namespace verisim::functions
