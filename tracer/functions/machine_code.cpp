// Code generation with xbyak. Every value has a home in the register array (rbx points to it) and is written through
// to it; besides, the translator remembers which xmm register holds which value, so that a value is read from memory
// only after a call or a jump target. xmm14 and xmm15 are scratch.
#include "tracer/functions/machine_code.h"

#if defined(__x86_64__) && defined(__linux__)

#include <xbyak/xbyak.h>

#include <bit>
#include <initializer_list>

namespace verisim::functions {

namespace {

constexpr std::size_t kMaxNativeInstructions = 20000;
constexpr int kCached = 14;
constexpr std::uint32_t kNothing = 0xffffffffu;

void call_function(const Call* call, double* r) { evaluate(*call, r, r + call->results); }

using Binary = double (*)(double, double);
// The library or helper function of an operation that has no instruction.
Binary library(Code code) {
  return with_code(code, []<Code C>() -> Binary { return [](double a, double b) { return apply<C>(a, b); }; });
}

// The predicates of cmpsd.
enum Predicate : std::uint8_t { kEqual, kLess, kLessEqual, kNotEqual = 4, kNotLess, kNotLessEqual };

}  // namespace

class MachineCode::Translator : public Xbyak::CodeGenerator {
 public:
  Translator(std::uint32_t first_constant, std::span<const double> constants)
      : CodeGenerator(Xbyak::DEFAULT_MAX_CODE_SIZE, Xbyak::AutoGrow),
        first_constant_(first_constant),
        constants_(constants) {
    forget();
  }

  void translate(const std::vector<Instruction>& code, const std::vector<Call>& calls, std::uint32_t result);

 private:
  using Xmm = Xbyak::Xmm;
  using Arithmetic = void (CodeGenerator::*)(const Xmm&, const Xbyak::Operand&);

  bool is_constant(std::uint32_t slot) const {
    return slot >= first_constant_ && slot - first_constant_ < constants_.size();
  }
  Xbyak::Address home(std::uint32_t slot) const {
    if (is_constant(slot)) return qword[rip + constants_label_ + static_cast<int>((slot - first_constant_) * 8)];
    return qword[rbx + slot * 8];
  }
  int cached(std::uint32_t slot) const {
    for (int r = 0; r < kCached; ++r)
      if (cached_[r] == slot) return r;
    return -1;
  }
  void forget() {
    for (std::uint32_t& c : cached_) c = kNothing;
  }
  // operation reg, value
  void with_value(Arithmetic operation, const Xmm& reg, std::uint32_t slot) {
    const int r = cached(slot);
    if (r >= 0)
      (this->*operation)(reg, Xmm(r));
    else
      (this->*operation)(reg, home(slot));
  }
  void load(const Xmm& reg, std::uint32_t slot) {
    const int r = cached(slot);
    if (r == reg.getIdx()) return;
    if (r >= 0)
      movapd(reg, Xmm(r));
    else
      movsd(reg, home(slot));
  }
  // A register for a new value; the oldest is reused. It must not be one that the current instruction reads.
  Xmm fresh(std::initializer_list<std::uint32_t> reads) {
    for (;;) {
      next_ = (next_ + 1) % kCached;
      bool read = false;
      for (const std::uint32_t slot : reads) read = read || (cached_[next_] == slot && slot != kNothing);
      if (!read) break;
    }
    cached_[next_] = kNothing;
    return Xmm(next_);
  }
  void define(std::uint32_t slot, const Xmm& reg) {
    for (std::uint32_t& c : cached_) {
      if (c == slot) c = kNothing;
    }
    cached_[reg.getIdx()] = slot;
    movsd(home(slot), reg);
  }
  void bits_to(const Xmm& reg, std::uint64_t bits) {
    mov(rax, bits);
    movq(reg, rax);
  }
  void call_address(const void* target) {
    mov(rax, std::bit_cast<std::uint64_t>(target));
    call(rax);
    forget();
  }
  // to = mask ? b : a; the mask is destroyed.
  void blend(const Xmm& to, const Xmm& mask, std::uint32_t b, std::uint32_t a) {
    load(to, b);
    andpd(to, mask);
    load(scratch_, a);
    andnpd(mask, scratch_);
    orpd(to, mask);
  }

  void arithmetic(Arithmetic operation, const Instruction& i) {
    const Xmm r = fresh({i.a, i.b});
    load(r, i.a);
    with_value(operation, r, i.b);
    define(i.to, r);
  }
  void compare(const Xmm& reg, std::uint32_t slot, Predicate predicate) {
    load(scratch_, slot);
    cmpsd(reg, scratch_, predicate);
  }
  void comparison(Predicate predicate, const Instruction& i) {
    const Xmm r = fresh({i.a, i.b});
    load(r, i.a);
    compare(r, i.b, predicate);
    bits_to(scratch_, std::bit_cast<std::uint64_t>(1.0));
    andpd(r, scratch_);
    define(i.to, r);
  }
  // b where the predicate holds for a and b, else a.
  void extreme(Predicate predicate, const Instruction& i) {
    const Xmm r = fresh({i.a, i.b});
    load(mask_, i.a);
    compare(mask_, i.b, predicate);
    blend(r, mask_, i.b, i.a);
    define(i.to, r);
  }
  void copy(const Instruction& i) {
    const Xmm r = fresh({i.a});
    load(r, i.a);
    define(i.to, r);
  }
  void sign(Arithmetic operation, std::uint64_t bits, const Instruction& i) {
    const Xmm r = fresh({i.a});
    load(r, i.a);
    bits_to(scratch_, bits);
    (this->*operation)(r, scratch_);
    define(i.to, r);
  }
  void square_root(const Instruction& i) {
    const Xmm r = fresh({i.a});
    with_value(&CodeGenerator::sqrtsd, r, i.a);
    define(i.to, r);
  }
  void select(const Instruction& i);
  void call_user(const Call& called);
  void call_library(const Instruction& i);
  void instruction(const Instruction& i, const std::vector<Call>& calls);
  void jump(const Instruction& i, const Xbyak::Label& target);

  std::uint32_t first_constant_;
  std::span<const double> constants_;
  Xbyak::Label constants_label_;
  const Xmm mask_{14}, scratch_{15};
  std::uint32_t cached_[kCached];
  int next_ = 0;
};

void MachineCode::Translator::select(const Instruction& i) {
  const Xmm r = fresh({i.a, i.b, i.c, i.d}), inner = fresh({i.a, i.b, i.c, i.d});
  const auto compare_with_zero = [&](Predicate predicate) {
    load(mask_, i.a);
    xorpd(scratch_, scratch_);
    cmpsd(mask_, scratch_, predicate);
  };
  compare_with_zero(kEqual);
  blend(inner, mask_, i.c, i.d);
  compare_with_zero(kLess);
  load(r, i.b);
  andpd(r, mask_);
  andnpd(mask_, inner);
  orpd(r, mask_);
  define(i.to, r);
}

// The callee's arguments are read from their homes; constants have theirs in the code.
void MachineCode::Translator::call_user(const Call& called) {
  for (const std::uint32_t slot : called.arguments) {
    if (!is_constant(slot)) continue;
    movsd(scratch_, home(slot));
    movsd(qword[rbx + slot * 8], scratch_);
  }
  mov(rdi, std::bit_cast<std::uint64_t>(&called));
  mov(rsi, rbx);
  call_address(std::bit_cast<const void*>(&call_function));
}

void MachineCode::Translator::call_library(const Instruction& i) {
  load(scratch_, i.a);
  if (is_binary(i.code)) {
    load(mask_, i.b);
    movapd(xmm1, mask_);
  }
  movapd(xmm0, scratch_);
  call_address(std::bit_cast<const void*>(library(i.code)));
  define(i.to, xmm0);
}

void MachineCode::Translator::instruction(const Instruction& i, const std::vector<Call>& calls) {
  constexpr std::uint64_t kSign = 0x8000000000000000u;
  switch (i.code) {
    case Code::add:
      return arithmetic(&CodeGenerator::addsd, i);
    case Code::multiply:
      return arithmetic(&CodeGenerator::mulsd, i);
    case Code::subtract:
      return arithmetic(&CodeGenerator::subsd, i);
    case Code::divide:
      return arithmetic(&CodeGenerator::divsd, i);
    case Code::less:
      return comparison(kLess, i);
    case Code::less_equal:
      return comparison(kLessEqual, i);
    case Code::equal:
      return comparison(kEqual, i);
    case Code::not_equal:
      return comparison(kNotEqual, i);
    case Code::greater_equal:
      return comparison(kNotLess, i);
    case Code::greater:
      return comparison(kNotLessEqual, i);
    case Code::minimum:
      return extreme(kNotLessEqual, i);
    case Code::maximum:
      return extreme(kLess, i);
    case Code::move:
      return copy(i);
    case Code::negate:
      return sign(&CodeGenerator::xorpd, kSign, i);
    case Code::abs:
      return sign(&CodeGenerator::andpd, ~kSign, i);
    case Code::sqrt:
      return square_root(i);
    case Code::select:
      return select(i);
    case Code::call:
      return call_user(calls[i.a]);
    default:
      return call_library(i);
  }
}

void MachineCode::Translator::jump(const Instruction& i, const Xbyak::Label& target) {
  switch (i.code) {
    case Code::jump_unless_negative:  // not 0 > a
      xorpd(scratch_, scratch_);
      with_value(&CodeGenerator::ucomisd, scratch_, i.a);
      return jbe(target, T_NEAR);
    case Code::jump_unless_zero:
      xorpd(scratch_, scratch_);
      with_value(&CodeGenerator::ucomisd, scratch_, i.a);
      jne(target, T_NEAR);
      return jp(target, T_NEAR);
    case Code::jump_unless_less_equal:  // not b >= a
      load(scratch_, i.b);
      with_value(&CodeGenerator::ucomisd, scratch_, i.a);
      return jb(target, T_NEAR);
    default:
      return jmp(target, T_NEAR);
  }
}

void MachineCode::Translator::translate(const std::vector<Instruction>& code, const std::vector<Call>& calls,
                                        std::uint32_t result) {
  std::vector<bool> is_target(code.size() + 1, false);
  for (const Instruction& i : code) {
    if (is_jump(i.code)) is_target[i.to] = true;
  }
  std::vector<Xbyak::Label> labels(code.size() + 1);
  push(rbx);
  mov(rbx, rdi);
  for (std::size_t k = 0; k <= code.size(); ++k) {
    if (is_target[k]) {
      forget();
      L(labels[k]);
    }
    if (k == code.size()) break;
    if (is_jump(code[k].code))
      jump(code[k], labels[code[k].to]);
    else
      instruction(code[k], calls);
  }
  load(xmm0, result);
  pop(rbx);
  ret();
  align(8);
  L(constants_label_);
  for (const double c : constants_) dq(std::bit_cast<std::uint64_t>(c));
  ready(PROTECT_RE);  // never writable and executable at once
}

MachineCode::MachineCode(std::unique_ptr<Translator> code) : code_(std::move(code)), entry_(code_->getCode<Entry>()) {}

MachineCode::~MachineCode() = default;

std::shared_ptr<const MachineCode> MachineCode::translate(const std::vector<Instruction>& code,
                                                          const std::vector<Call>& calls, std::uint32_t first_constant,
                                                          std::span<const double> constants, std::uint32_t result) {
  if (code.size() > kMaxNativeInstructions) return nullptr;
  try {
    auto translator = std::make_unique<Translator>(first_constant, constants);
    translator->translate(code, calls, result);
    return std::shared_ptr<const MachineCode>(new MachineCode(std::move(translator)));
  } catch (const Xbyak::Error&) {  // executable memory is refused
    return nullptr;
  }
}

}  // namespace verisim::functions

#else

namespace verisim::functions {

class MachineCode::Translator {};

MachineCode::~MachineCode() = default;

std::shared_ptr<const MachineCode> MachineCode::translate(const std::vector<Instruction>&, const std::vector<Call>&,
                                                          std::uint32_t, std::span<const double>, std::uint32_t) {
  return nullptr;
}

}  // namespace verisim::functions

#endif
