// Limits of the process as a whole that decide nothing about a picture.
#pragma once

#include <cstdint>
#include <string>

namespace verisim::cli {

struct ProcessLimits {
  std::string sandbox = "off";         // or strict, best-effort (cli/sandbox/sandbox.h)
  std::uint64_t max_output_bytes = 0;  // that scenes may write and say; 0: no limit
  std::uint64_t max_rays = 0;          // of one picture; 0: no limit
};
inline ProcessLimits process_limits;  // as the arguments have them

}  // namespace verisim::cli
