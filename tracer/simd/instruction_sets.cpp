#include "tracer/simd/instruction_sets.h"

#include <cstdlib>
#include <string_view>

namespace verisim::simd {
namespace {

constexpr std::string_view kNames[kInstructionSets] = {"baseline", "sse4", "avx2", "avx512"};

// By the environment; empty: none is asked for.
std::string_view requested() {
  const char* name = std::getenv("VERISIM_INSTRUCTION_SET");
  return name ? name : "";
}

// What each_target.h has kernels compiled for. (Noise has the baseline alone with compilers other than GCC.)
InstructionSet find_best() {
#if defined(__x86_64__) && !defined(HWY_COMPILE_ONLY_STATIC)  // else the baseline is what the compiler was told
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("ssse3") || !__builtin_cpu_supports("sse4.1") || !__builtin_cpu_supports("sse4.2"))
    return kBaseline;
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("bmi") || !__builtin_cpu_supports("bmi2") ||
      !__builtin_cpu_supports("fma"))
    return kSse4;
  const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  return wide ? kAvx512 : kAvx2;
#else
  return kBaseline;
#endif
}

InstructionSet find_best_allowed() {
  const InstructionSet best = find_best();
  for (int set = 0; set < best; ++set)
    if (requested() == kNames[set]) return static_cast<InstructionSet>(set);
  return best;
}

}  // namespace

InstructionSet best_instruction_set() {
  static const InstructionSet best = find_best_allowed();
  return best;
}

std::string wrong_instruction_set() {
  if (requested().empty()) return "";
  std::string known;
  for (int set = 0; set <= find_best(); ++set) {
    if (requested() == kNames[set]) return "";
    known += (set > 0 ? ", " : "") + std::string(kNames[set]);
  }
  return "VERISIM_INSTRUCTION_SET is '" + std::string(requested()) + "'; this machine can run " + known;
}

}  // namespace verisim::simd
