// One picture from its scene: parse, render, write. What `verisim render` does for every frame.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/console/exit_status.h"
#include "cli/frame/job.h"

namespace verisim::cli {

struct FrameReport {
  ExitStatus status = kOk;
  bool skipped = false;          // +C and the picture is there
  std::string message;           // the first error, as one line
  std::filesystem::path output;  // empty: none was written
  double seconds_parse = 0, cpu_parse = 0, seconds_render = 0, cpu_render = 0, seconds_write = 0;
  int warnings = 0;
  render::Statistics statistics;
  std::vector<std::string> stochastic_features;
  std::vector<std::filesystem::path> files_read;
};

FrameReport render_frame(const Job& job, const Frame& frame);

// Seconds of user and system time this process has used.
double cpu_seconds();

}  // namespace verisim::cli
