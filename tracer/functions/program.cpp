#include "tracer/functions/program.h"

#include "tracer/functions/machine_code.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"  // vectors are only passed to functions that are inlined
#endif
#if defined(__x86_64__) && defined(__GNUC__)
#define VERISIM_AVX2 __attribute__((target("avx2")))
#define VERISIM_HAS_AVX2 1
#endif

namespace verisim::functions {

namespace {

constexpr std::uint32_t kStackRegisters = 128;

}  // namespace

namespace {

// sum and prod may run over any range: a scene must not be able to hang. All loops of one evaluation, with those of the functions it calls, share
// this many passes; then the value is NaN, and the parser makes an error of it.
constexpr std::uint64_t kMostPasses = 100'000'000;
thread_local int loops_open = 0;
thread_local std::uint64_t passes_left = 0;
thread_local bool overran = false;

class LoopBudget {
 public:
  ~LoopBudget() {
    if (open_) --loops_open;
  }
  bool pass() {
    if (!open_) {
      open_ = true;
      if (!loops_open++) passes_left = kMostPasses;
    }
    if (passes_left) {
      --passes_left;
      return true;
    }
    overran = true;
    return false;
  }

 private:
  bool open_ = false;
};

}  // namespace

bool take_loop_overrun() { return std::exchange(overran, false); }

double Program::run(double* r) const {
  LoopBudget budget;
  const Instruction* const begin = code_.data();
  const Instruction* const end = begin + code_.size();
  for (const Instruction* i = begin; i != end; ++i) {
    switch (i->code) {
#define VERISIM_BINARY(NAME) \
  case Code::NAME: r[i->to] = apply<Code::NAME>(r[i->a], r[i->b]); break;
#define VERISIM_UNARY(NAME) \
  case Code::NAME: r[i->to] = apply<Code::NAME>(r[i->a]); break;
      VERISIM_BINARY(add) VERISIM_BINARY(subtract) VERISIM_BINARY(multiply) VERISIM_BINARY(divide)
      VERISIM_BINARY(less) VERISIM_BINARY(less_equal) VERISIM_BINARY(equal) VERISIM_BINARY(not_equal)
      VERISIM_BINARY(greater_equal) VERISIM_BINARY(greater) VERISIM_BINARY(logic_and) VERISIM_BINARY(logic_or)
      VERISIM_BINARY(minimum) VERISIM_BINARY(maximum) VERISIM_BINARY(atan2) VERISIM_BINARY(mod) VERISIM_BINARY(div) VERISIM_BINARY(pow)
      VERISIM_UNARY(negate) VERISIM_UNARY(abs) VERISIM_UNARY(acos) VERISIM_UNARY(acosh) VERISIM_UNARY(asin) VERISIM_UNARY(asinh)
      VERISIM_UNARY(atan) VERISIM_UNARY(atanh) VERISIM_UNARY(ceil) VERISIM_UNARY(cos) VERISIM_UNARY(cosh) VERISIM_UNARY(degrees)
      VERISIM_UNARY(exp) VERISIM_UNARY(floor) VERISIM_UNARY(integer) VERISIM_UNARY(ln) VERISIM_UNARY(log) VERISIM_UNARY(radians)
      VERISIM_UNARY(sin) VERISIM_UNARY(sinh) VERISIM_UNARY(sqrt) VERISIM_UNARY(tan) VERISIM_UNARY(tanh) VERISIM_UNARY(move)
#undef VERISIM_BINARY
#undef VERISIM_UNARY
      case Code::select: r[i->to] = select(r[i->a], r[i->b], r[i->c], r[i->d]); break;
      case Code::call: {
        const Call& call = calls_[i->a];
        double arguments[kMaxFunctionParameters];
        const std::size_t n = call.arguments.size();
        for (std::size_t k = 0; k < n; ++k) arguments[k] = r[call.arguments[k]];
        call.function->evaluate({arguments, n}, r + call.results);
        break;
      }
      case Code::jump: {
        const Instruction* const to = begin + i->to;
        if (to <= i && !budget.pass()) return std::numeric_limits<double>::quiet_NaN();
        i = to - 1;
        break;
      }
      case Code::jump_unless_negative: if (!(r[i->a] < 0)) i = begin + i->to - 1; break;
      case Code::jump_unless_zero: if (!(r[i->a] == 0)) i = begin + i->to - 1; break;
      case Code::jump_unless_less_equal: if (!(r[i->a] <= r[i->b])) i = begin + i->to - 1; break;
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
  if (registers_ > kStackRegisters) return evaluate_long(arguments, result);
  double r[kStackRegisters];
  r[0] = n > 0 ? arguments[0] : 0, r[1] = n > 1 ? arguments[1] : 0, r[2] = n > 2 ? arguments[2] : 0;  // a loop would become a call of memcpy
  for (std::size_t k = 3; k < n; ++k) r[k] = arguments[k];
  if (native_) {
    *result = native_->run(r);
    return;
  }
  for (std::size_t k = 0; k < constants_.size(); ++k) r[n + k] = constants_[k];
  *result = run(r);
}

// Only very long functions have so many values that the stack is no place for them.
void Program::evaluate_long(std::span<const double> arguments, double* result) const {
  const auto r = std::make_unique<double[]>(registers_);
  const auto n = static_cast<std::size_t>(parameters_);
  for (std::size_t k = 0; k < n; ++k) r[k] = arguments[k];
  for (std::size_t k = 0; k < constants_.size(); ++k) r[n + k] = constants_[k];
  *result = native_ ? native_->run(r.get()) : run(r.get());
}

namespace {

using Vector = double __attribute__((vector_size(32)));
using Mask = long long __attribute__((vector_size(32)));

[[gnu::always_inline]] inline Vector load(const double* p) {
  Vector v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
[[gnu::always_inline]] inline void store(double* p, const Vector& v) { std::memcpy(p, &v, sizeof v); }
[[gnu::always_inline]] inline Vector choose(const Mask& m, const Vector& a, const Vector& b) {
  return reinterpret_cast<Vector>((m & reinterpret_cast<Mask>(a)) | (~m & reinterpret_cast<Mask>(b)));
}
[[gnu::always_inline]] inline Vector truth(const Mask& m) {
  const Vector one = {1, 1, 1, 1};
  return reinterpret_cast<Vector>(m & reinterpret_cast<Mask>(one));
}

// The operations that map to vector instructions; same rules as apply<>.
template <Code C>
constexpr bool kVectorised = C == Code::add || C == Code::subtract || C == Code::multiply || C == Code::divide || C == Code::less ||
                             C == Code::less_equal || C == Code::equal || C == Code::not_equal || C == Code::greater_equal ||
                             C == Code::greater || C == Code::minimum || C == Code::maximum || C == Code::negate || C == Code::abs ||
                             C == Code::degrees || C == Code::radians || C == Code::move;

template <Code C>
[[gnu::always_inline]] inline Vector apply_vector(const Vector& a, const Vector& b) {
  if constexpr (C == Code::add) return a + b;
  else if constexpr (C == Code::subtract) return a - b;
  else if constexpr (C == Code::multiply) return a * b;
  else if constexpr (C == Code::divide) return a / b;
  else if constexpr (C == Code::less) return truth(a < b);
  else if constexpr (C == Code::less_equal) return truth(a <= b);
  else if constexpr (C == Code::equal) return truth(a == b);
  else if constexpr (C == Code::not_equal) return truth(~(a == b));
  else if constexpr (C == Code::greater_equal) return truth(~(a < b));
  else if constexpr (C == Code::greater) return truth(~(a <= b));
  else if constexpr (C == Code::minimum) return choose(b >= a, a, b);
  else if constexpr (C == Code::maximum) return choose(b > a, b, a);
  else if constexpr (C == Code::negate) return -a;
  else if constexpr (C == Code::abs) {
    const Mask sign = {INT64_MAX, INT64_MAX, INT64_MAX, INT64_MAX};
    return reinterpret_cast<Vector>(reinterpret_cast<Mask>(a) & sign);
  }
  else if constexpr (C == Code::degrees) return a * (180.0 / 3.14159265358979323846);
  else if constexpr (C == Code::radians) return a * (3.14159265358979323846 / 180.0);
  else return a;
}

template <Code C, int Width>
[[gnu::always_inline]] inline void operate(double* to, const double* a, const double* b, std::size_t count) {
  if constexpr (kVectorised<C>) {
    for (int k = 0; k < Width; k += 4) store(to + k, apply_vector<C>(load(a + k), load(b + k)));
  } else {
    for (std::size_t k = 0; k < count; ++k) to[k] = apply<C>(a[k], b[k]);
  }
}

}  // namespace

template <int Width>
[[gnu::always_inline]] inline void Program::run_block(double* r, std::size_t count) const {
  for (const Instruction& i : code_) {
    double* const to = r + std::size_t{i.to} * Width;
    const double* const a = r + std::size_t{i.a} * Width;
    const double* const b = r + std::size_t{i.b} * Width;
    switch (i.code) {
#define VERISIM_OPERATE(NAME) \
  case Code::NAME: operate<Code::NAME, Width>(to, a, b, count); break;
      VERISIM_OPERATE(add) VERISIM_OPERATE(subtract) VERISIM_OPERATE(multiply) VERISIM_OPERATE(divide)
      VERISIM_OPERATE(less) VERISIM_OPERATE(less_equal) VERISIM_OPERATE(equal) VERISIM_OPERATE(not_equal)
      VERISIM_OPERATE(greater_equal) VERISIM_OPERATE(greater) VERISIM_OPERATE(logic_and) VERISIM_OPERATE(logic_or)
      VERISIM_OPERATE(minimum) VERISIM_OPERATE(maximum) VERISIM_OPERATE(atan2) VERISIM_OPERATE(mod) VERISIM_OPERATE(div)
      VERISIM_OPERATE(pow) VERISIM_OPERATE(negate) VERISIM_OPERATE(abs) VERISIM_OPERATE(acos) VERISIM_OPERATE(acosh)
      VERISIM_OPERATE(asin) VERISIM_OPERATE(asinh) VERISIM_OPERATE(atan) VERISIM_OPERATE(atanh) VERISIM_OPERATE(ceil)
      VERISIM_OPERATE(cos) VERISIM_OPERATE(cosh) VERISIM_OPERATE(degrees) VERISIM_OPERATE(exp) VERISIM_OPERATE(floor)
      VERISIM_OPERATE(integer) VERISIM_OPERATE(ln) VERISIM_OPERATE(log) VERISIM_OPERATE(radians) VERISIM_OPERATE(sin)
      VERISIM_OPERATE(sinh) VERISIM_OPERATE(sqrt) VERISIM_OPERATE(tan) VERISIM_OPERATE(tanh) VERISIM_OPERATE(move)
#undef VERISIM_OPERATE
      case Code::select: {
        const double *c = r + std::size_t{i.c} * Width, *d = r + std::size_t{i.d} * Width;
        const Vector zero = {0, 0, 0, 0};
        for (int k = 0; k < Width; k += 4) {
          const Vector s = load(a + k);
          store(to + k, choose(s < zero, load(b + k), choose(s == zero, load(c + k), load(d + k))));
        }
        break;
      }
      case Code::call: {
        const Call& call = calls_[i.a];
        double arguments[static_cast<std::size_t>(Width) * 8];
        const std::size_t n = call.arguments.size();
        if (n <= 8) {
          for (std::size_t p = 0; p < n; ++p) {
            std::copy_n(r + std::size_t{call.arguments[p]} * Width, count, arguments + p * Width);
          }
          call.function->evaluate_batch(arguments, Width, count, r + std::size_t{call.results} * Width);
        } else {
          const auto outputs = static_cast<std::size_t>(call.function->components());
          double values[kMaxFunctionComponents], point[kMaxFunctionParameters];
          for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t p = 0; p < n; ++p) point[p] = r[std::size_t{call.arguments[p]} * Width + k];
            call.function->evaluate({point, n}, values);
            for (std::size_t c = 0; c < outputs; ++c) r[(call.results + c) * Width + k] = values[c];
          }
        }
        break;
      }
      default: break;  // programs with jumps never get here
    }
  }
}

template <int Width>
[[gnu::always_inline]] inline void Program::batch(double* r, const double* arguments, std::size_t stride, std::size_t count,
                                                  double* result) const {
  const auto n = static_cast<std::size_t>(parameters_);
  for (std::size_t k = 0; k < constants_.size(); ++k) std::fill_n(r + (n + k) * Width, Width, constants_[k]);
  for (std::size_t begin = 0; begin < count; begin += Width) {
    const std::size_t m = std::min<std::size_t>(Width, count - begin);
    for (std::size_t p = 0; p < n; ++p) {
      std::copy_n(arguments + p * stride + begin, m, r + p * Width);
      for (std::size_t k = m; k < Width; ++k) r[p * Width + k] = 0;  // unused lanes must not be slow (denormals, NaN)
    }
    run_block<Width>(r, m);
    std::copy_n(r + std::size_t{result_} * Width, m, result + begin);
  }
}

namespace {

constexpr int kNarrow = 8, kWide = 64;
constexpr std::size_t kWorthABatch = 4;  // fewer points are faster one by one in native code

#ifdef VERISIM_HAS_AVX2
bool has_avx2() {
  static const bool result = __builtin_cpu_supports("avx2");
  return result;
}
#endif

}  // namespace

// The same code for two instruction sets: the bodies are inlined into each.
void Program::batch_narrow(double* r, const double* arguments, std::size_t stride, std::size_t count, double* result) const {
  batch<kNarrow>(r, arguments, stride, count, result);
}
void Program::batch_wide(double* r, const double* arguments, std::size_t stride, std::size_t count, double* result) const {
  batch<kWide>(r, arguments, stride, count, result);
}
#ifdef VERISIM_HAS_AVX2
VERISIM_AVX2 void Program::batch_narrow_avx2(double* r, const double* arguments, std::size_t stride, std::size_t count, double* result) const {
  batch<kNarrow>(r, arguments, stride, count, result);
}
VERISIM_AVX2 void Program::batch_wide_avx2(double* r, const double* arguments, std::size_t stride, std::size_t count, double* result) const {
  batch<kWide>(r, arguments, stride, count, result);
}
#endif

void Program::evaluate_batch(const double* arguments, std::size_t stride, std::size_t count, double* result) const {
  if (count == 0) return;
  if (has_jumps_ || (native_ && count < kWorthABatch)) return Function::evaluate_batch(arguments, stride, count, result);
  const bool narrow = count <= kNarrow;
  alignas(32) double stack[std::size_t{kStackRegisters} * kNarrow * 2];
  std::unique_ptr<double[]> heap;
  double* r = stack;
  const std::size_t width = narrow ? kNarrow : kWide;
  if (registers_ * width > std::size(stack)) {
    heap = std::make_unique<double[]>(registers_ * width);
    r = heap.get();
  }
#ifdef VERISIM_HAS_AVX2
  if (has_avx2()) return narrow ? batch_narrow_avx2(r, arguments, stride, count, result) : batch_wide_avx2(r, arguments, stride, count, result);
#endif
  narrow ? batch_narrow(r, arguments, stride, count, result) : batch_wide(r, arguments, stride, count, result);
}

}  // namespace verisim::functions
