// Which of the versions of a vectorised function this machine can run. All versions of a function give the same bits.
#pragma once

#include <string>

namespace verisim::simd {

enum InstructionSet { kBaseline, kSse4, kAvx2, kAvx512, kInstructionSets };

// The best one here, or the one that the environment variable VERISIM_INSTRUCTION_SET names (baseline, sse4, avx2,
// avx512), to compare pictures and times; all before it run as well.
InstructionSet best_instruction_set();
// What is wrong with that variable; empty: nothing.
std::string wrong_instruction_set();

}  // namespace verisim::simd
