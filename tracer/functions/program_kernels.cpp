#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tracer/functions/evaluation_budget.h"
#include "tracer/functions/program_packet.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/functions/program_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/functions/library-inl.h"
#include "tracer/functions/approximate_sine-inl.h"
#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::functions {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

#include "tracer/functions/exact_operations.inc"

// What the lanes of `active` cannot do together.
template <Code C>
HWY_INLINE void one_by_one(double* to, const double* a, const double* b, std::uint64_t active) {
  for (; active != 0; active &= active - 1) {
    const int k = std::countr_zero(active);
    to[k] = apply<C>(a[k], b[k]);
  }
}

template <Code C, bool Nearly>
HWY_INLINE void eight(double* to, const double* a, const double* b, std::uint64_t active) {
  if constexpr (kExact<C>) {
    store(to, exact<C>(load(a), load(b)));
  } else if constexpr (C == Code::sqrt) {
    store(to, sqrt(load(a)));
  } else if constexpr (Nearly && (C == Code::sin || C == Code::cos)) {
    store(to, approximate_sine<C == Code::cos>(load(a)));
#if HWY_NATIVE_FMA
  } else if constexpr (C == Code::sin || C == Code::cos || C == Code::atan2 || C == Code::ln || C == Code::pow) {
    for (int n = 0; n < kLanes; n += kPart) {
      const Part first = Part::load(a + n), second = Part::load(b + n);
      Part result;
      unsigned unsure;
      if constexpr (C == Code::atan2)
        unsure = arc<Nearly>(first, second, result);
      else if constexpr (C == Code::ln)
        unsure = logarithm(first, result);
      else if constexpr (C == Code::pow)
        unsure = power(first, second, result);
      else
        unsure = sine<C == Code::cos>(reduced(first), result);
      store(to + n, result);
      for (unsure &= static_cast<unsigned>(active >> n); unsure != 0; unsure &= unsure - 1) {
        const int k = std::countr_zero(unsure);
        to[n + k] = apply<C>(first[k], second[k]);
      }
    }
#endif
  } else {
    one_by_one<C>(to, a, b, active);
  }
}

template <Code C, int Width, bool Nearly>
HWY_INLINE void operate(double* to, const double* a, const double* b, std::uint64_t active) {
  for (int k = 0; k < Width; k += kLanes) eight<C, Nearly>(to + k, a + k, b + k, active >> k & 255);
}

template <int Width>
void call_function(const Call& call, double* r, std::uint64_t active) {
  constexpr std::size_t kMax = 8;  // arguments that are handed over for all points at once
  const std::size_t inputs = call.arguments.size();
  const auto outputs = static_cast<std::size_t>(call.function->components());
  double* const results = r + std::size_t{call.results} * Width;
  EvaluationBudget budget;  // eight points count as one
  if (!budget.spend(call.passes * (Width / kLanes))) {
    std::fill_n(results, outputs * Width, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  if (inputs <= kMax) {
    // Side by side, without gaps.
    double arguments[Width * kMax], values[Width * kMaxFunctionComponents];
    if (Width == kLanes && active == 255) {
      for (std::size_t p = 0; p < inputs; ++p)
        store(arguments + p * Width, load(r + std::size_t{call.arguments[p]} * Width));
      call.function->evaluate_batch(arguments, Width, Width, results);
      return;
    }
    std::size_t count = 0;
    for (std::uint64_t lanes = active; lanes != 0; lanes &= lanes - 1, ++count)
      for (std::size_t p = 0; p < inputs; ++p)
        arguments[p * Width + count] =
            r[std::size_t{call.arguments[p]} * Width + static_cast<std::size_t>(std::countr_zero(lanes))];
    call.function->evaluate_batch(arguments, Width, count, values);
    count = 0;
    for (std::uint64_t lanes = active; lanes != 0; lanes &= lanes - 1, ++count)
      for (std::size_t c = 0; c < outputs; ++c)
        results[c * Width + static_cast<std::size_t>(std::countr_zero(lanes))] = values[c * Width + count];
    return;
  }
  double values[kMaxFunctionComponents], point[kMaxFunctionParameters];
  for (; active != 0; active &= active - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(active));
    for (std::size_t p = 0; p < inputs; ++p) point[p] = r[std::size_t{call.arguments[p]} * Width + k];
    call.function->evaluate({point, inputs}, values);
    for (std::size_t c = 0; c < outputs; ++c) results[c * Width + k] = values[c];
  }
}

template <int Width, bool Nearly>
void run(std::span<const Instruction> code, std::span<const Call> calls, double* r, std::uint64_t active) {
  for (const Instruction& i : code) {
    double* const to = r + std::size_t{i.to} * Width;
    const double* const a = r + std::size_t{i.a} * Width;
    const double* const b = r + std::size_t{i.b} * Width;
    switch (i.code) {
#define VERISIM_OPERATE(NAME)                             \
  case Code::NAME:                                        \
    operate<Code::NAME, Width, Nearly>(to, a, b, active); \
    break;
      VERISIM_OPERATIONS(VERISIM_OPERATE)
#undef VERISIM_OPERATE
      case Code::select: {
        const double *c = r + std::size_t{i.c} * Width, *d = r + std::size_t{i.d} * Width;
        for (int k = 0; k < Width; k += kLanes) {
          const Packet s = load(a + k), zero(0.0);
          store(to + k, select(s < zero, load(b + k), select(s == zero, load(c + k), load(d + k))));
        }
        break;
      }
      case Code::call:
        call_function<Width>(calls[i.a], r, active);
        break;
      default:
        break;  // programs with jumps never get here
    }
  }
}

constexpr ProgramKernels kKernels{run<ProgramKernels::kNarrow, false>, run<ProgramKernels::kNarrow, true>,
                                  run<ProgramKernels::kBroad, false>, run<ProgramKernels::kWide, false>};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::functions
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::functions {
VERISIM_EXPORT_KERNELS(ProgramKernels, packet_kernels)
}  // namespace verisim::functions
#endif
