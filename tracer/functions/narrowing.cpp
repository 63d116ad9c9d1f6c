#include "tracer/functions/narrowing.h"

#include <cmath>
#include <cstdint>

namespace verisim::functions {
namespace {

// Whether an operation's result only rises or only falls with a sum that its operands may hang on.
bool one_direction(Code code, bool a, bool b) {
  if (!a && !b) return true;
  switch (code) {
    case Code::move:
    case Code::negate:
      return true;
    case Code::add:
    case Code::subtract:
    case Code::multiply:
    case Code::minimum:
    case Code::maximum:
      return !(a && b);
    case Code::divide:
      return !b;
    default:
      return false;
  }
}

}  // namespace

std::unique_ptr<const Narrowing> Narrowing::of(const Function* function) {
  const auto* const program = dynamic_cast<const Program*>(function);
  if (!program || program->has_jumps() || program->parameters() != 3 || program->calls().size() != 1) return nullptr;
  if (program->registers() + program->code().size() > kMaxRegisters) return nullptr;
  const Call& call = program->calls()[0];
  auto narrowing = std::make_unique<Narrowing>();
  narrowing->sum_ = dynamic_cast<const OctaveSum*>(call.function.get());
  if (!narrowing->sum_) return nullptr;

  double constants[kMaxRegisters] = {};
  program->set_constants(constants, 1);
  std::uint8_t place[kMaxRegisters];  // of what the program's registers hold
  bool hangs[kMaxRegisters] = {};     // on the sum
  for (std::uint8_t r = 0; r < kMaxRegisters; ++r)
    place[r] = r, narrowing->registers_[r] = {constants[r], constants[r]};
  auto next = static_cast<std::uint8_t>(program->registers());
  bool active = false;
  for (const Instruction& i : program->code()) {
    if (i.code == Code::call) {
      for (std::size_t k = 0; k < call.arguments.size(); ++k) {
        const std::uint32_t argument = call.arguments[k];
        const bool constant = argument >= 3 && place[argument] == argument;
        if (k >= 3 && !constant) return nullptr;
        narrowing->arguments_.push_back(place[argument]);
      }
      narrowing->of_sum_ = place[call.results] = next;
      hangs[next++] = active = true;
      continue;
    }
    const bool binary = is_binary(i.code);
    if (!binary && !is_unary(i.code)) return nullptr;
    const std::uint8_t a = place[i.a], b = binary ? place[i.b] : a;
    if (!one_direction(i.code, hangs[a], binary && hangs[b])) return nullptr;
    (active ? narrowing->behind_ : narrowing->before_).push_back({i.code, next, a, b});
    hangs[next] = hangs[a] || hangs[b];
    place[i.to] = next++;
  }
  narrowing->result_ = place[program->result_register()];
  return narrowing;
}

void Narrowing::run(std::span<const Step> steps, Bounds* r) {
  for (const Step& s : steps) {
    r[s.to] = with_code(s.code, [a = r[s.a], b = r[s.b]]<Code C>() {
      return Bounds{apply<C>(a.low, b.low), apply<C>(a.high, b.high)};
    });
  }
}

template <class Sum>
Bounds Narrowing::evaluate(const Vec3& p, Workspace& workspace, Sum sum) const {
  Bounds* const r = workspace.registers.data();
  for (int axis = 0; axis < 3; ++axis) r[axis] = {p[axis], p[axis]};
  run(before_, r);
  double arguments[kMaxFunctionParameters];
  for (std::size_t k = 0; k < arguments_.size(); ++k) arguments[k] = r[arguments_[k]].low;
  r[of_sum_] = sum(std::span<const double>(arguments, arguments_.size()));
  run(behind_, r);
  const auto [a, b] = r[result_];
  return a <= b ? Bounds{a, b} : Bounds{b, a};
}

void Narrowing::begin(const Vec3& p, Value& value, Workspace& workspace) const {
  value.p = p;
  value.bounds = evaluate(p, workspace, [&](std::span<const double> arguments) {
    return sum_->begin(arguments, value.sum, workspace.sums);
  });
}

bool Narrowing::narrow(Value& value, Workspace& workspace) const {
  if (value.exact() || value.sum.done == workspace.sums.count) return false;
  value.bounds = evaluate(value.p, workspace, [&](std::span<const double> arguments) {
    return sum_->narrow(arguments, value.sum, workspace.sums);
  });
  return true;
}

}  // namespace verisim::functions
