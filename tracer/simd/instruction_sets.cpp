#include "tracer/simd/instruction_sets.h"

namespace verisim::simd {
namespace {

// What each_target.h has kernels compiled for. Those that each_instruction_set.inc still compiles have the baseline
// only with compilers other than GCC, so others take it for all.
InstructionSet find_best() {
#if defined(__x86_64__) && !defined(__clang__)
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("bmi") || !__builtin_cpu_supports("bmi2") ||
      !__builtin_cpu_supports("fma"))
    return kBaseline;
  const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  return wide ? kAvx512 : kAvx2;
#else
  return kBaseline;
#endif
}

}  // namespace

InstructionSet best_instruction_set() {
  static const InstructionSet best = find_best();
  return best;
}

}  // namespace verisim::simd
