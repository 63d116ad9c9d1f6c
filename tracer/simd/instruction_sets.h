// Which of the versions of a vectorised function this machine can run. All versions of a function give the same bits.
#pragma once

namespace verisim::simd {

enum InstructionSet { kBaseline, kAvx2, kAvx512, kInstructionSets };

// The best one here; all before it run as well.
InstructionSet best_instruction_set();

}  // namespace verisim::simd
