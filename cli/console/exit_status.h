// How a run ends, for scripts.
#pragma once

namespace verisim::cli {

// Exit statuses of every subcommand; calls in POV-Ray's style use 0, 1 and 2 as `povray` does (spec 02 section 12).
enum ExitStatus : int {
  kOk = 0,
  kDifferent = 1,  // a comparison or a threshold failed
  kUsage = 2,
  kSceneErrors = 3,
  kUnsupported = 4,  // the scene uses something verisim cannot render; the message names it and its place
  kInputOutput = 5,
  kInterrupted = 130,
};

}  // namespace verisim::cli
