// Code generation. Every value has a home in the register array (rbx points to it) and is written through to it;
// besides, the translator remembers which xmm register holds which value, so that a value is read from memory only
// after a call or a jump target. xmm14 and xmm15 are scratch.
#include "tracer/functions/machine_code.h"

#if defined(__x86_64__) && defined(__linux__)
#define VERISIM_NATIVE_CODE 1
#include <sys/mman.h>
#endif

#include <bit>
#include <cmath>
#include <cstring>
#include <initializer_list>

namespace verisim::functions {

MachineCode::~MachineCode() {
#ifdef VERISIM_NATIVE_CODE
  if (memory_) munmap(memory_, size_);
#endif
}

#ifdef VERISIM_NATIVE_CODE

namespace {

constexpr std::size_t kMaxInstructions = 20000;
constexpr int kCached = 14, kScratch = 15, kScratch2 = 14;
constexpr std::uint32_t kNothing = 0xffffffffu;

void call_function(const Call* call, double* r) {
  double arguments[kMaxFunctionParameters];
  const std::size_t n = call->arguments.size();
  for (std::size_t k = 0; k < n; ++k) arguments[k] = r[call->arguments[k]];
  call->function->evaluate({arguments, n}, r + call->results);
}

using Binary = double (*)(double, double);
// The library or helper function of an operation that has no instruction.
Binary library(Code code) {
  return with_code(code, []<Code C>() -> Binary { return [](double a, double b) { return apply<C>(a, b); }; });
}

class Translator {
 public:
  Translator(std::uint32_t first_constant, std::span<const double> constants)
      : first_constant_(first_constant), constants_(constants) {
    for (std::uint32_t& c : cached_) c = kNothing;
  }

  std::vector<std::uint8_t> translate(const std::vector<Instruction>& code, const std::vector<Call>& calls,
                                      std::uint32_t result);

 private:
  void bytes(std::initializer_list<int> values) {
    for (const int v : values) out_.push_back(static_cast<std::uint8_t>(v));
  }
  void imm32(std::uint32_t v) {
    for (int k = 0; k < 4; ++k) out_.push_back(static_cast<std::uint8_t>(v >> (8 * k)));
  }
  void imm64(std::uint64_t v) {
    for (int k = 0; k < 8; ++k) out_.push_back(static_cast<std::uint8_t>(v >> (8 * k)));
  }
  // prefix 0F op with an xmm destination and an xmm source.
  void xmm(int prefix, int op, int to, int from) {
    bytes({prefix});
    if (to > 7 || from > 7) bytes({0x40 | (to > 7 ? 4 : 0) | (from > 7 ? 1 : 0)});
    bytes({0x0f, op, 0xc0 | (to & 7) << 3 | (from & 7)});
  }
  // The same with a value's home as source (or destination, for stores).
  void xmm_home(int prefix, int op, int reg, std::uint32_t slot) {
    bytes({prefix});
    if (reg > 7) bytes({0x44});
    if (is_constant(slot)) {
      bytes({0x0f, op, 0x05 | (reg & 7) << 3});  // rip-relative, resolved at the end
      fixups_.push_back({out_.size(), slot - first_constant_});
      imm32(0);
    } else {
      bytes({0x0f, op, 0x83 | (reg & 7) << 3});
      imm32(slot * 8);
    }
  }
  bool is_constant(std::uint32_t slot) const {
    return slot >= first_constant_ && slot - first_constant_ < constants_.size();
  }
  int cached(std::uint32_t slot) const {
    for (int r = 0; r < kCached; ++r) {
      if (cached_[r] == slot) return r;
    }
    return -1;
  }
  void forget() {
    for (std::uint32_t& c : cached_) c = kNothing;
  }
  // op reg, value
  void with_value(int prefix, int op, int reg, std::uint32_t slot) {
    const int r = cached(slot);
    if (r >= 0)
      xmm(prefix, op, reg, r);
    else
      xmm_home(prefix, op, reg, slot);
  }
  void load(int reg, std::uint32_t slot) {
    const int r = cached(slot);
    if (r == reg) return;
    if (r >= 0)
      xmm(0x66, 0x28, reg, r);  // movapd
    else
      xmm_home(0xf2, 0x10, reg, slot);  // movsd
  }
  // A register for a new value; the oldest is reused. It must not be one that the current instruction reads.
  int fresh(std::initializer_list<std::uint32_t> reads) {
    for (;;) {
      next_ = (next_ + 1) % kCached;
      bool read = false;
      for (const std::uint32_t slot : reads) read = read || (cached_[next_] == slot && slot != kNothing);
      if (!read) break;
    }
    cached_[next_] = kNothing;
    return next_;
  }
  void define(std::uint32_t slot, int reg) {
    for (std::uint32_t& c : cached_) {
      if (c == slot) c = kNothing;
    }
    cached_[reg] = slot;
    xmm_home(0xf2, 0x11, reg, slot);
  }
  void constant_to_scratch(int scratch, std::uint64_t bits) {
    bytes({0x48, 0xb8});  // mov rax, imm64
    imm64(bits);
    bytes({0x66, 0x4c, 0x0f, 0x6e, 0xc0 | (scratch & 7) << 3});  // movq xmm8+, rax
  }
  void call_address(const void* target) {
    bytes({0x48, 0xb8});
    imm64(std::bit_cast<std::uint64_t>(target));
    bytes({0xff, 0xd0});
    forget();
  }
  void compare(int reg, std::uint32_t slot, int predicate) {
    load(kScratch, slot);  // not from memory: the byte behind the operand would upset the address of a constant
    xmm(0xf2, 0xc2, reg, kScratch);
    bytes({predicate});
  }
  // to = mask & b | ~mask & a, mask in `mask` (destroyed).
  void blend(int to, int mask, std::uint32_t b, std::uint32_t a) {
    load(to, b);
    xmm(0x66, 0x54, to, mask);  // andpd
    load(kScratch, a);
    xmm(0x66, 0x55, mask, kScratch);  // andnpd: ~mask & a
    xmm(0x66, 0x56, to, mask);        // orpd
  }
  void instruction(const Instruction& i, const std::vector<Call>& calls);
  void jump(const Instruction& i);

  struct Fixup {
    std::size_t at;
    std::uint32_t target;
  };
  std::uint32_t first_constant_;
  std::span<const double> constants_;
  std::vector<std::uint8_t> out_;
  std::vector<Fixup> fixups_, jumps_;
  std::uint32_t cached_[kCached];
  int next_ = 0;
};

void Translator::instruction(const Instruction& i, const std::vector<Call>& calls) {
  constexpr std::uint64_t kOne = 0x3ff0000000000000u, kSign = 0x8000000000000000u;
  const auto arithmetic = [&](int op) {
    const int r = fresh({i.a, i.b});
    load(r, i.a);
    with_value(0xf2, op, r, i.b);
    define(i.to, r);
  };
  const auto comparison = [&](int predicate) {
    const int r = fresh({i.a, i.b});
    load(r, i.a);
    compare(r, i.b, predicate);
    constant_to_scratch(kScratch, kOne);
    xmm(0x66, 0x54, r, kScratch);
    define(i.to, r);
  };
  const auto extreme = [&](int predicate) {
    const int r = fresh({i.a, i.b});
    load(kScratch2, i.a);
    compare(kScratch2, i.b, predicate);
    blend(r, kScratch2, i.b, i.a);
    define(i.to, r);
  };
  switch (i.code) {
    case Code::add:
      return arithmetic(0x58);
    case Code::multiply:
      return arithmetic(0x59);
    case Code::subtract:
      return arithmetic(0x5c);
    case Code::divide:
      return arithmetic(0x5e);
    case Code::less:
      return comparison(1);
    case Code::less_equal:
      return comparison(2);
    case Code::equal:
      return comparison(0);
    case Code::not_equal:
      return comparison(4);
    case Code::greater_equal:
      return comparison(5);  // not less
    case Code::greater:
      return comparison(6);  // not less or equal
    case Code::minimum:
      return extreme(6);  // not a <= b: b
    case Code::maximum:
      return extreme(1);  // a < b: b
    case Code::move: {
      const int r = fresh({i.a});
      load(r, i.a);
      return define(i.to, r);
    }
    case Code::negate:
    case Code::abs: {
      const int r = fresh({i.a});
      load(r, i.a);
      constant_to_scratch(kScratch, i.code == Code::abs ? ~kSign : kSign);
      xmm(0x66, i.code == Code::abs ? 0x54 : 0x57, r, kScratch);
      return define(i.to, r);
    }
    case Code::sqrt: {
      const int r = fresh({i.a});
      with_value(0xf2, 0x51, r, i.a);
      return define(i.to, r);
    }
    case Code::select: {
      const int r = fresh({i.a, i.b, i.c, i.d}), inner = fresh({i.a, i.b, i.c, i.d});
      // inner = a == 0 ? c : d
      load(kScratch2, i.a);
      xmm(0x66, 0x57, kScratch, kScratch);
      xmm(0xf2, 0xc2, kScratch2, kScratch), bytes({0});
      blend(inner, kScratch2, i.c, i.d);
      // r = a < 0 ? b : inner
      load(kScratch2, i.a);
      xmm(0x66, 0x57, kScratch, kScratch);
      xmm(0xf2, 0xc2, kScratch2, kScratch), bytes({1});
      load(r, i.b);
      xmm(0x66, 0x54, r, kScratch2);
      xmm(0x66, 0x55, kScratch2, inner);
      xmm(0x66, 0x56, r, kScratch2);
      return define(i.to, r);
    }
    case Code::call: {
      const Call& call = calls[i.a];
      for (const std::uint32_t slot : call.arguments) {
        if (!is_constant(slot)) continue;
        xmm_home(0xf2, 0x10, kScratch,
                 slot);  // constants live in the code; the callee's arguments are read from their homes
        bytes({0xf2, 0x44, 0x0f, 0x11, 0x83 | (kScratch & 7) << 3});
        imm32(slot * 8);
      }
      bytes({0x48, 0xbf});  // mov rdi, imm64
      imm64(std::bit_cast<std::uint64_t>(&call));
      bytes({0x48, 0x89, 0xde});  // mov rsi, rbx
      return call_address(std::bit_cast<const void*>(&call_function));
    }
    default: {
      load(kScratch, i.a);
      if (is_binary(i.code)) {
        load(kScratch2, i.b);
        xmm(0x66, 0x28, 1, kScratch2);
      }
      xmm(0x66, 0x28, 0, kScratch);
      call_address(std::bit_cast<const void*>(library(i.code)));
      return define(i.to, 0);
    }
  }
}

void Translator::jump(const Instruction& i) {
  const auto to = [&] {
    jumps_.push_back({out_.size(), i.to});
    imm32(0);
  };
  switch (i.code) {
    case Code::jump_unless_negative:  // not 0 > a
      xmm(0x66, 0x57, kScratch, kScratch);
      with_value(0x66, 0x2e, kScratch, i.a);
      bytes({0x0f, 0x86}), to();  // jbe
      break;
    case Code::jump_unless_zero:
      xmm(0x66, 0x57, kScratch, kScratch);
      with_value(0x66, 0x2e, kScratch, i.a);
      bytes({0x0f, 0x85}), to();  // jne
      bytes({0x0f, 0x8a}), to();  // jp
      break;
    case Code::jump_unless_less_equal:  // not b >= a
      load(kScratch, i.b);
      with_value(0x66, 0x2e, kScratch, i.a);
      bytes({0x0f, 0x82}), to();  // jb
      break;
    default:
      bytes({0xe9}), to();
      break;
  }
}

std::vector<std::uint8_t> Translator::translate(const std::vector<Instruction>& code, const std::vector<Call>& calls,
                                                std::uint32_t result) {
  std::vector<bool> is_target(code.size() + 1, false);
  for (const Instruction& i : code) {
    if (is_jump(i.code)) is_target[i.to] = true;
  }
  // The constants come first.
  for (const double c : constants_) imm64(std::bit_cast<std::uint64_t>(c));
  bytes({0x53, 0x48, 0x89, 0xfb});  // push rbx; mov rbx, rdi
  std::vector<std::size_t> starts;
  for (std::size_t k = 0; k <= code.size(); ++k) {
    if (is_target[k]) forget();
    starts.push_back(out_.size());
    if (k == code.size()) break;
    if (is_jump(code[k].code))
      jump(code[k]);
    else
      instruction(code[k], calls);
  }
  load(0, result);
  bytes({0x5b, 0xc3});  // pop rbx; ret
  const auto patch = [&](std::size_t at, std::size_t target) {
    const auto distance =
        static_cast<std::uint32_t>(static_cast<std::int64_t>(target) - static_cast<std::int64_t>(at) - 4);
    std::memcpy(&out_[at], &distance, 4);
  };
  for (const Fixup& f : fixups_) patch(f.at, std::size_t{f.target} * 8);
  for (const Fixup& f : jumps_) patch(f.at, starts[f.target]);
  return std::move(out_);
}

}  // namespace

std::shared_ptr<const MachineCode> MachineCode::translate(const std::vector<Instruction>& code,
                                                          const std::vector<Call>& calls, std::uint32_t first_constant,
                                                          std::span<const double> constants, std::uint32_t result) {
  if (code.size() > kMaxInstructions) return nullptr;
  const std::vector<std::uint8_t> bytes = Translator(first_constant, constants).translate(code, calls, result);
  void* memory = mmap(nullptr, bytes.size(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return nullptr;
  std::shared_ptr<MachineCode> result_code(new MachineCode);
  result_code->memory_ = memory, result_code->size_ = bytes.size();
  std::memcpy(memory, bytes.data(), bytes.size());
  // Never writable and executable at once.
  if (mprotect(memory, bytes.size(), PROT_READ | PROT_EXEC) != 0) return nullptr;
  result_code->entry_ = reinterpret_cast<Entry>(static_cast<std::uint8_t*>(memory) + constants.size() * 8);
  return result_code;
}

#else

std::shared_ptr<const MachineCode> MachineCode::translate(const std::vector<Instruction>&, const std::vector<Call>&,
                                                          std::uint32_t, std::span<const double>, std::uint32_t) {
  return nullptr;
}

#endif

}  // namespace verisim::functions
