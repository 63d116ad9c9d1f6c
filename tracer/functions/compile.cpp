// From the folded expression to a program: values are numbered (equal ones once), constants evaluated, small functions
// inlined, registers shared.
#include <array>
#include <bit>
#include <map>
#include <optional>
#include <stdexcept>

#include "tracer/functions/evaluation_budget.h"
#include "tracer/functions/fold.h"
#include "tracer/functions/program.h"

namespace verisim::functions {

namespace {

constexpr std::size_t kInlineLimit =
    400;  // expression nodes (nested inlining included) of a function that is copied into its caller
constexpr std::size_t kInlineTotal = 4096;    // instructions after which nothing more is inlined
constexpr std::size_t kEagerSelectCost = 24;  // in simple operations: cheaper branches are evaluated both
constexpr std::size_t kMaxInstructions = 1u << 22;

// In the order of Builtin.
constexpr Code kCodes[] = {Code::abs,     Code::acos,    Code::acosh, Code::asin,    Code::asinh,   Code::atan,
                           Code::atan2,   Code::atanh,   Code::ceil,  Code::cos,     Code::cosh,    Code::degrees,
                           Code::div,     Code::exp,     Code::floor, Code::integer, Code::ln,      Code::log,
                           Code::maximum, Code::minimum, Code::mod,   Code::pow,     Code::radians, Code::select,
                           Code::sin,     Code::sinh,    Code::sqrt,  Code::tan,     Code::tanh};
static_assert(std::size(kCodes) == static_cast<std::size_t>(Builtin::tanh_) + 1 &&
              kCodes[static_cast<int>(Builtin::max_)] == Code::maximum);

Code code_of(Builtin builtin) { return kCodes[static_cast<std::size_t>(builtin)]; }

// A rough cost in simple operations.
std::size_t cost(const Node& node) {
  const auto all = [](const std::vector<Node>& nodes) {
    std::size_t sum = 0;
    for (const Node& n : nodes) sum += cost(n);
    return sum;
  };
  if (const auto* chain = std::get_if<Chain>(&node.value)) return all(chain->operands) + chain->operators.size();
  if (const auto* negate = std::get_if<Negate>(&node.value)) return all(negate->operand) + 1;
  if (const auto* builtin = std::get_if<BuiltinCall>(&node.value)) return all(builtin->arguments) + 4;
  if (const auto* call = std::get_if<UserCall>(&node.value)) return all(call->arguments) + 1000;
  if (std::holds_alternative<Loop>(node.value)) return 1000;
  return 0;
}

}  // namespace

// Virtual registers are numbered without limit first; `finish` packs them.
class Builder {
 public:
  using Register = std::uint32_t;

  Builder(int parameters, int slots) : environment_(static_cast<std::size_t>(slots)) {
    program_ = std::make_shared<Program>();
    program_->parameters_ = parameters;
    program_->slots_ = slots;
    for (int k = 0; k < parameters; ++k) environment_[static_cast<std::size_t>(k)] = next_++;
    scopes_.emplace_back();
  }

  Register lower(const Node& node);
  std::shared_ptr<const Program> finish(Register result, Node expression);

 private:
  using Key = std::array<std::uint64_t, 6>;

  Register constant(double value);
  std::optional<double> known(Register r) const;
  Register emit(Code code, Register a, Register b = 0, Register c = 0, Register d = 0);
  void push(const Instruction& instruction);
  Register power(Register x, int exponent);
  Register lower_chain(const Chain& chain);
  Register lower_builtin(const BuiltinCall& call);
  Register lower_select(const BuiltinCall& call);
  Register lower_call(const UserCall& call);
  Register lower_loop(const Loop& loop);
  void branch(const Node& node, Register to);
  // From where to where in the code a virtual register holds a value.
  struct Life {
    static constexpr std::size_t kNever = static_cast<std::size_t>(-1);
    std::size_t begin = kNever, end = 0;
    bool fixed = false;
    bool used() const { return begin != kNever; }
  };
  std::vector<Life> lives(Register result) const;
  Register place_fixed(std::vector<Life>& life, std::vector<Register>& place);
  void pack(Register& result);

  std::shared_ptr<Program> program_;
  std::vector<Register> environment_;  // value of each parameter and loop variable
  std::vector<std::map<Key, Register>>
      scopes_;  // values known where the code stands; inner scopes are conditional code
  std::map<std::uint64_t, Register> constants_;  // by bit pattern
  std::map<Register, double> constant_values_;
  std::vector<std::pair<std::size_t, std::size_t>> loops_;  // instruction ranges
  Register next_ = 0;
};

Builder::Register Builder::constant(double value) {
  const auto [at, fresh] = constants_.try_emplace(std::bit_cast<std::uint64_t>(value), next_);
  if (fresh) constant_values_[next_++] = value;
  return at->second;
}

std::optional<double> Builder::known(Register r) const {
  const auto at = constant_values_.find(r);
  return at == constant_values_.end() ? std::nullopt : std::optional(at->second);
}

void Builder::push(const Instruction& instruction) {
  if (program_->code_.size() >= kMaxInstructions) throw std::invalid_argument("Function is too long.");
  program_->code_.push_back(instruction);
}

Builder::Register Builder::emit(Code code, Register a, Register b, Register c, Register d) {
  if (code == Code::select) {
    if (const auto s = known(a)) return *s < 0 ? b : *s == 0 ? c : d;
  } else if (const auto x = known(a)) {
    const auto y = is_binary(code) ? known(b) : std::optional(0.0);
    if (y) return constant(with_code(code, [&]<Code C>() { return apply<C>(*x, *y); }));
  }
  const Key key{static_cast<std::uint64_t>(code), a, b, c, d, 0};
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    if (const auto at = scope->find(key); at != scope->end()) return at->second;
  }
  push({code, next_, a, b, c, d});
  scopes_.back()[key] = next_;
  return next_++;
}

Builder::Register Builder::lower(const Node& node) {
  ++program_->lowered_nodes_;
  if (const auto* value = std::get_if<Constant>(&node.value)) return constant(value->value);
  if (const auto* parameter = std::get_if<Parameter>(&node.value))
    return environment_.at(static_cast<std::size_t>(parameter->index));
  if (const auto* chain = std::get_if<Chain>(&node.value)) return lower_chain(*chain);
  if (const auto* negate = std::get_if<Negate>(&node.value)) return emit(Code::negate, lower(negate->operand[0]));
  if (const auto* builtin = std::get_if<BuiltinCall>(&node.value)) {
    return builtin->builtin == Builtin::select_ ? lower_select(*builtin) : lower_builtin(*builtin);
  }
  if (const auto* call = std::get_if<UserCall>(&node.value)) return lower_call(*call);
  if (const auto* loop = std::get_if<Loop>(&node.value)) return lower_loop(*loop);
  return constant(0);  // Zero
}

Builder::Register Builder::lower_chain(const Chain& chain) {
  Register left = lower(chain.operands[0]);
  for (std::size_t i = 0; i < chain.operators.size(); ++i) {
    const Node& operand = chain.operands[i + 1];
    if (chain.operators[i] == Op::divide && is_literal(operand)) {
      const double divisor = std::get<Constant>(operand.value).value;
      if (divisor == 0) throw std::invalid_argument("Division by zero.");
      left = emit(Code::multiply, left, constant(1 / divisor));
    } else {
      left = emit(code_of(chain.operators[i]), left, lower(operand));
    }
  }
  return left;
}

Builder::Register Builder::power(Register x, int exponent) {
  const auto times = [&](Register a, Register b) { return emit(Code::multiply, a, b); };
  const Register x2 = times(x, x);
  if (exponent == 2) return x2;
  if (exponent == 3) return times(x2, x);
  const Register x4 = times(x2, x2);
  if (exponent == 4) return x4;
  if (exponent == 5) return times(x4, x);
  if (exponent == 6) return times(x4, x2);
  if (exponent == 7) return times(times(x4, x), x2);
  return times(x4, x4);
}

Builder::Register Builder::lower_builtin(const BuiltinCall& call) {
  const Code code = code_of(call.builtin);
  if (code == Code::pow && is_literal(call.arguments[1])) {
    const double exponent = std::get<Constant>(call.arguments[1].value).value;
    if (exponent == 0) return constant(1);
    if (exponent >= 2 && exponent <= 8 && exponent == std::floor(exponent))
      return power(lower(call.arguments[0]), static_cast<int>(exponent));
  }
  Register left = lower(call.arguments[0]);
  if (is_unary(code)) return emit(code, left);
  for (std::size_t i = 1; i < call.arguments.size(); ++i) left = emit(code, left, lower(call.arguments[i]));
  return left;
}

void Builder::branch(const Node& node, Register to) {
  scopes_.emplace_back();
  push({Code::move, to, lower(node)});
  scopes_.pop_back();
}

Builder::Register Builder::lower_select(const BuiltinCall& call) {
  const bool four = call.arguments.size() == 4;
  const Node &negative = call.arguments[1], &zero = call.arguments[2], &positive = call.arguments[four ? 3 : 2];
  const Register condition = lower(call.arguments[0]);
  if (const auto s = known(condition)) return lower(*s < 0 ? negative : *s == 0 ? zero : positive);
  if (cost(negative) + cost(zero) + (four ? cost(positive) : 0) <= kEagerSelectCost) {
    const Register b = lower(negative), c = lower(zero), d = four ? lower(positive) : c;
    return emit(Code::select, condition, b, c, d);
  }
  program_->has_jumps_ = true;
  auto& code = program_->code_;
  const auto here = [&] { return static_cast<std::uint32_t>(code.size()); };
  const Register result = next_++;
  const std::size_t unless_negative = code.size();
  push({Code::jump_unless_negative, 0, condition});
  branch(negative, result);
  const std::size_t done = code.size();
  push({Code::jump});
  code[unless_negative].to = here();
  if (four) {
    const std::size_t unless_zero = code.size();
    push({Code::jump_unless_zero, 0, condition});
    branch(zero, result);
    const std::size_t done_too = code.size();
    push({Code::jump});
    code[unless_zero].to = here();
    branch(positive, result);
    code[done_too].to = here();
  } else {
    branch(zero, result);
  }
  code[done].to = here();
  return result;
}

Builder::Register Builder::lower_call(const UserCall& call) {
  std::vector<Register> arguments;
  arguments.reserve(call.arguments.size());
  for (const Node& n : call.arguments) arguments.push_back(lower(n));
  const auto* program = dynamic_cast<const Program*>(call.function.get());
  if (program) {
    if (program->lowered_nodes() <= kInlineLimit && program_->code_.size() < kInlineTotal) {
      std::vector<Register> inner(static_cast<std::size_t>(program->slots()), 0);
      std::copy(arguments.begin(), arguments.end(), inner.begin());
      std::swap(environment_, inner);
      const Register result = lower(program->expression());
      std::swap(environment_, inner);
      return result;
    }
  }
  // Equal calls are made once: the key lists the arguments, too many of them are not compared.
  const int components = call.function->components();
  Register results = next_;
  bool fresh = true;
  const bool comparable = arguments.size() <= 4;
  Key key{static_cast<std::uint64_t>(Code::call) << 32, std::bit_cast<std::uint64_t>(call.function.get()), 0, 0, 0, 0};
  if (comparable) {
    for (std::size_t i = 0; i < arguments.size(); ++i) key[2 + i] = arguments[i] + 1;
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend() && fresh; ++scope) {
      if (const auto at = scope->find(key); at != scope->end()) results = at->second, fresh = false;
    }
  }
  if (fresh) {
    next_ += static_cast<Register>(components);
    if (comparable) scopes_.back()[key] = results;
    push({Code::call, results, static_cast<std::uint32_t>(program_->calls_.size())});
    const std::size_t passes = kPassesOfACall + (program ? program->code_.size() : 0);
    program_->calls_.push_back({call.function, std::move(arguments), results, passes});
  }
  const auto component = [&](int k) { return k < components ? results + static_cast<Register>(k) : constant(0); };
  if (call.grey) {
    const Register red = emit(Code::multiply, constant(0.297), component(0)),
                   green = emit(Code::multiply, constant(0.589), component(1)),
                   blue = emit(Code::multiply, constant(0.114), component(2));
    return emit(Code::add, emit(Code::add, red, green), blue);
  }
  if (call.hf) {
    const Register low = emit(Code::divide, component(1), constant(255));
    return emit(Code::multiply, constant(0.996093), emit(Code::add, component(0), low));
  }
  return component(call.component);
}

// i = first; while i <= last: accumulate, i += 1.
Builder::Register Builder::lower_loop(const Loop& loop) {
  program_->has_jumps_ = true;
  auto& code = program_->code_;
  const Register first = lower(loop.parts[0]), last = lower(loop.parts[1]);
  const Register one = constant(1), variable = next_++, sum = next_++;
  push({Code::move, variable, first});
  push({Code::move, sum, constant(loop.product ? 1 : 0)});
  const std::size_t begin = code.size();
  push({Code::jump_unless_less_equal, 0, variable, last});
  const auto slot = static_cast<std::size_t>(loop.variable);
  if (slot >= environment_.size()) environment_.resize(slot + 1);
  const Register outer = environment_[slot];
  environment_[slot] = variable;
  scopes_.emplace_back();
  const Register value = lower(loop.parts[2]);
  scopes_.pop_back();
  environment_[slot] = outer;
  push({loop.product ? Code::multiply : Code::add, sum, sum, value});
  push({Code::add, variable, variable, one});
  push({Code::jump, static_cast<std::uint32_t>(begin)});
  code[begin].to = static_cast<std::uint32_t>(code.size());
  loops_.emplace_back(begin, code.size() - 1);
  return sum;
}

std::vector<Builder::Life> Builder::lives(Register result) const {
  const auto& code = program_->code_;
  std::vector<Life> life(next_);
  const auto use = [&](Register r, std::size_t at) {
    if (!life[r].used()) life[r].begin = at;
    life[r].end = std::max(life[r].end, at);
  };
  for (std::size_t at = 0; at < code.size(); ++at) {
    const Instruction& i = code[at];
    if (i.code == Code::call)
      for (const Register r : program_->calls_[i.a].arguments) use(r, at);
    if (i.code == Code::call || i.code == Code::jump) continue;
    use(i.a, at);
    if (is_binary(i.code) || i.code == Code::jump_unless_less_equal || i.code == Code::select) use(i.b, at);
    if (i.code == Code::select) use(i.c, at), use(i.d, at);
    if (!is_jump(i.code)) use(i.to, at);
  }
  use(result, code.size());
  // Inner loops come first in loops_: what is alive when a loop begins and used inside it is alive until its end.
  for (const auto& [begin, end] : loops_) {
    for (Life& l : life) {
      if (l.used() && l.begin < begin && l.end >= begin) l.end = std::max(l.end, end);
    }
  }
  return life;
}

// Parameters, constants and results of calls keep their places, which come first. Returns how many those are.
Builder::Register Builder::place_fixed(std::vector<Life>& life, std::vector<Register>& place) {
  Register used = 0;
  for (Register r = 0; r < static_cast<Register>(program_->parameters_); ++r) life[r].fixed = true, place[r] = used++;
  for (const auto& [r, value] : constant_values_) {
    life[r].fixed = true;
    if (!life[r].used()) continue;
    place[r] = used++;
    program_->constants_.push_back(value);
  }
  for (Call& call : program_->calls_) {
    const auto components = static_cast<Register>(call.function->components());
    for (Register k = 0; k < components; ++k) life[call.results + k].fixed = true, place[call.results + k] = used + k;
    call.results = used;
    used += components;
  }
  return used;
}

// Gives virtual registers that do not live at the same time the same place.
void Builder::pack(Register& result) {
  auto& code = program_->code_;
  std::vector<Life> life = lives(result);
  std::vector<Register> place(next_, 0);
  Register used = place_fixed(life, place);
  std::vector<std::vector<Register>> ends(code.size() + 1);  // virtual registers by last use
  for (Register r = 0; r < next_; ++r) {
    if (!life[r].fixed && life[r].used()) ends[life[r].end].push_back(r);
  }
  std::vector<Register> free;
  std::vector<bool> placed(next_, false);
  for (std::size_t at = 0; at < code.size(); ++at) {
    const Instruction& i = code[at];
    const bool defines = !is_jump(i.code) && i.code != Code::call;
    // Operands that end here give their place to the result: every operation reads before it writes.
    for (const Register r : ends[at]) {
      if (placed[r] && !(defines && r == i.to)) free.push_back(place[r]);
    }
    if (defines && !life[i.to].fixed && !placed[i.to]) {
      placed[i.to] = true;
      if (free.empty())
        place[i.to] = used++;
      else
        place[i.to] = free.back(), free.pop_back();
    }
  }
  for (Instruction& i : code) {
    if (i.code == Code::call || i.code == Code::jump) continue;
    i.a = place[i.a], i.b = place[i.b], i.c = place[i.c], i.d = place[i.d];
    if (!is_jump(i.code)) i.to = place[i.to];
  }
  for (Call& call : program_->calls_) {
    for (Register& r : call.arguments) r = place[r];
  }
  result = place[result];
  program_->registers_ = std::max<Register>(used, 1);
}

std::shared_ptr<const Program> Builder::finish(Register result, Node expression) {
  pack(result);
  program_->result_ = result;
  program_->expression_ = std::move(expression);
  program_->make_native();
  return program_;
}

FunctionPtr compile(const Node& root, int parameters, int slots) {
  Node folded = root;
  fold(folded);
  Builder builder(parameters, std::max(slots, parameters));
  const Builder::Register result = builder.lower(folded);
  return builder.finish(result, std::move(folded));
}

}  // namespace verisim::functions
