// POV-Ray run once, in a folder that is already a copy.
#pragma once

#include "compare/compare.h"
#include "compare/oracle/process.h"

namespace verisim::compare {

// How a renderer's process ended.
inline NativeResult::Ending ending_of(const ProcessResult& run) {
  if (run.crashed()) return NativeResult::Ending::by_signal;
  return run.timed_out ? NativeResult::Ending::out_of_time : NativeResult::Ending::by_itself;
}

// `variant` as in run_oracle. The time limit is that of the request.
NativeResult render_with_povray(const OracleProgram& program, const OracleOptions& options,
                                const NativeRequest& request, int variant);

}  // namespace verisim::compare
