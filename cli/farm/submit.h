// `verisim farm submit`: from words to a job and its folder.
#pragma once

#include <string>
#include <vector>

#include "cli/console/exit_status.h"
#include "cli/farm/job.h"
#include "cli/settings/options.h"

namespace verisim::cli {

struct SubmitRequest {
  std::vector<std::string> words;  // of `verisim render`, and what they mean:
  Options options;
  std::string folder, engine, program;  // empty: after the picture's name; this program
  EngineOptions engine_options;
  int parts = 0, frames_per_task = 0;  // 0: whatever is best
};

// The scene cannot be rendered; what is wrong has been said.
struct SceneRefused {
  ExitStatus status;
};

// Reads the scene and plans the job; writes nothing. Throws OptionError, SceneRefused and std::runtime_error.
FarmJob plan_job(const SubmitRequest& request);

// Makes the job's folder with all that is in it before tasks run. Throws std::runtime_error; then nothing is left.
void make_folder(const FarmJob& job);

}  // namespace verisim::cli
