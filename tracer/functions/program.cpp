#include "tracer/functions/program.h"

#include "tracer/functions/evaluation_budget.h"
#include "tracer/functions/machine_code.h"
#include "tracer/functions/program_packet.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <utility>

namespace verisim::functions {

namespace {

constexpr std::uint32_t kStackRegisters = 128;
constexpr std::align_val_t kRegisterAlignment{64};

struct FreeRegisters {
  void operator()(double* p) const { ::operator delete[](p, kRegisterAlignment); }
};

}  // namespace

void evaluate(const Call& call, const double* registers, double* results) {
  EvaluationBudget budget;
  if (!budget.spend(call.passes)) {
    std::fill_n(results, call.function->components(), std::numeric_limits<double>::quiet_NaN());
    return;
  }
  double arguments[kMaxFunctionParameters];
  const std::size_t n = call.arguments.size();
  for (std::size_t k = 0; k < n; ++k) arguments[k] = registers[call.arguments[k]];
  call.function->evaluate({arguments, n}, results);
}

double Program::run(double* r) const {
  EvaluationBudget budget;
  const Instruction* const begin = code_.data();
  const Instruction* const end = begin + code_.size();
  for (const Instruction* i = begin; i != end; ++i) {
    switch (i->code) {
#define VERISIM_OPERATE(NAME)                       \
  case Code::NAME:                                  \
    r[i->to] = apply<Code::NAME>(r[i->a], r[i->b]); \
    break;
      VERISIM_OPERATIONS(VERISIM_OPERATE)
#undef VERISIM_OPERATE
      case Code::select:
        r[i->to] = select(r[i->a], r[i->b], r[i->c], r[i->d]);
        break;
      case Code::call:
        functions::evaluate(calls_[i->a], r, r + calls_[i->a].results);
        break;
      case Code::jump: {
        const Instruction* const to = begin + i->to;
        if (to <= i && !budget.spend()) return std::numeric_limits<double>::quiet_NaN();
        i = to - 1;
        break;
      }
      case Code::jump_unless_negative:
        if (!(r[i->a] < 0)) i = begin + i->to - 1;
        break;
      case Code::jump_unless_zero:
        if (!(r[i->a] == 0)) i = begin + i->to - 1;
        break;
      case Code::jump_unless_less_equal:
        if (!(r[i->a] <= r[i->b])) i = begin + i->to - 1;
        break;
    }
  }
  return r[result_];
}

void Program::make_native() {
  // Loops are interpreted, so that their passes can be counted.
  for (std::size_t i = 0; i < code_.size(); ++i)
    if (code_[i].code == Code::jump && code_[i].to <= i) return;
  native_ = MachineCode::translate(code_, calls_, static_cast<std::uint32_t>(parameters_), constants_, result_);
}

void Program::evaluate(std::span<const double> arguments, double* result) const {
  const auto n = static_cast<std::size_t>(parameters_);
  if (registers_ > kStackRegisters) {
    *result = evaluate_long(arguments, is_native());
    return;
  }
  double r[kStackRegisters];
  r[0] = n > 0 ? arguments[0] : 0, r[1] = n > 1 ? arguments[1] : 0,
  r[2] = n > 2 ? arguments[2] : 0;  // a loop would become a call of memcpy
  for (std::size_t k = 3; k < n; ++k) r[k] = arguments[k];
  if (native_) {
    *result = native_->run(r);
    return;
  }
  for (std::size_t k = 0; k < constants_.size(); ++k) r[n + k] = constants_[k];
  *result = run(r);
}

double Program::interpret(std::span<const double> arguments) const { return evaluate_long(arguments, false); }

// Only very long functions have so many values that the stack is no place for them.
double Program::evaluate_long(std::span<const double> arguments, bool native) const {
  const auto r = std::make_unique<double[]>(registers_);
  const auto n = static_cast<std::size_t>(parameters_);
  for (std::size_t k = 0; k < n; ++k) r[k] = arguments[k];
  for (std::size_t k = 0; k < constants_.size(); ++k) r[n + k] = constants_[k];
  return native ? native_->run(r.get()) : run(r.get());
}

void Program::set_constants(double* registers, std::size_t width) const {
  const auto n = static_cast<std::size_t>(parameters_);
  for (std::size_t k = 0; k < constants_.size(); ++k) std::fill_n(registers + (n + k) * width, width, constants_[k]);
}

void Program::evaluate_batch(const double* arguments, std::size_t stride, std::size_t count, double* result) const {
  constexpr std::size_t kNarrow = ProgramKernels::kNarrow, kWide = ProgramKernels::kWide;
  constexpr std::size_t kWorthABatch = 4;  // fewer points are faster one by one in native code
  if (count == 0) return;
  if (has_jumps_ || (native_ && count < kWorthABatch))
    return Function::evaluate_batch(arguments, stride, count, result);
  const std::size_t width = count <= kNarrow ? kNarrow : kWide;
  alignas(64) double stack[kStackRegisters * kNarrow * 2];
  std::unique_ptr<double[], FreeRegisters> heap;
  double* r = stack;
  if (registers_ * width > std::size(stack)) {
    heap.reset(static_cast<double*>(::operator new[](registers_* width * sizeof(double), kRegisterAlignment)));
    r = heap.get();
  }
  set_constants(r, width);
  const auto n = static_cast<std::size_t>(parameters_);
  const auto run = width == kNarrow ? packet_kernels().narrow : packet_kernels().wide;
  for (std::size_t begin = 0; begin < count; begin += width) {
    const std::size_t m = std::min(width, count - begin);
    for (std::size_t p = 0; p < n; ++p) {
      std::copy_n(arguments + p * stride + begin, m, r + p * width);
      std::fill_n(r + p * width + m, width - m, 0.0);  // unused lanes must not be slow (denormals, NaN)
    }
    run(code_, calls_, r, m == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << m) - 1);
    std::copy_n(r + std::size_t{result_} * width, m, result + begin);
  }
}

}  // namespace verisim::functions
