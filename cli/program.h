// The program as a function: what main() calls, and tests, too.
#pragma once

#include <string>
#include <vector>

namespace verisim::cli {

// Exit statuses of every subcommand; calls in POV-Ray's style use 0, 1 and 2 as `povray` does (spec 02 section 12).
enum ExitStatus : int {
  kOk = 0,
  kDifferent = 1,    // a comparison or a threshold failed
  kUsage = 2,
  kSceneErrors = 3,
  kUnsupported = 4,  // the scene uses something verisim cannot render; the message names it and its place
  kInputOutput = 5,
  kInterrupted = 130,
};

// arguments[0] is the name the program was called by.
int run(const std::vector<std::string>& arguments);

}  // namespace verisim::cli
