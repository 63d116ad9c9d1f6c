// A user function as straight code for a register machine.
//
// Registers are doubles: first the parameters, then the constants, then intermediate values. One point is evaluated
// with the registers on the stack; a batch keeps a block of points per register and runs over whole SIMD vectors
// (program_packet.h). Programs with jumps (loops, `select` with costly branches) are evaluated point by point.
#pragma once

#include <vector>

#include "tracer/functions/expression.h"
#include "tracer/functions/operations.h"

namespace verisim::functions {

struct Instruction {
  Code code;
  std::uint32_t to = 0, a = 0, b = 0, c = 0, d = 0;
};

// A call of another function: its arguments are copied from registers, its components go to consecutive registers.
struct Call {
  FunctionPtr function;
  std::vector<std::uint32_t> arguments;
  std::uint32_t results = 0;
  std::uint64_t passes = 0;  // what it counts as (evaluation_budget.h)
};
// Counted (evaluation_budget.h); the components go to `results`.
void evaluate(const Call& call, const double* registers, double* results);

class MachineCode;

class Program final : public Function {
 public:
  int parameters() const override { return parameters_; }
  int components() const override { return 1; }
  void evaluate(std::span<const double> arguments, double* result) const override;
  void evaluate_batch(const double* arguments, std::size_t stride, std::size_t count, double* result) const override;

  // What native code and packets do, an instruction at a time; loops and processors without native code have only this.
  double interpret(std::span<const double> arguments) const;
  bool is_native() const { return native_ != nullptr; }

  std::size_t size() const { return code_.size(); }
  bool has_jumps() const { return has_jumps_; }
  // For ProgramKernels.
  std::size_t registers() const { return registers_; }
  std::size_t result_register() const { return result_; }
  std::span<const Instruction> code() const { return code_; }
  std::span<const Call> calls() const { return calls_; }
  void set_constants(double* registers, std::size_t width) const;
  // The folded expression, for inlining into other functions.
  const Node& expression() const { return expression_; }
  int slots() const { return slots_; }
  std::size_t lowered_nodes() const { return lowered_nodes_; }

 private:
  friend class Builder;
  void make_native();
  double evaluate_long(std::span<const double> arguments, bool native) const;
  double run(double* registers) const;

  int parameters_ = 0, slots_ = 0;
  std::size_t lowered_nodes_ = 0;
  std::vector<double> constants_;  // registers parameters_ ...
  std::vector<Instruction> code_;
  std::vector<Call> calls_;
  std::uint32_t registers_ = 0, result_ = 0;
  bool has_jumps_ = false;
  std::shared_ptr<const MachineCode> native_;  // null: interpreted
  Node expression_;
};

}  // namespace verisim::functions
