// `verisim farm wait`: until a job is done, or nothing of it is left that could get done.
#pragma once

#include <string>

#include "cli/console/exit_status.h"
#include "cli/farm/engine.h"

namespace verisim::cli {

// Shows how far all tasks are, in a style of --progress. Returns kInputOutput when steps failed and nothing runs any
// more.
ExitStatus wait_for(const FarmJob& job, Engine& engine, const std::string& progress);

}  // namespace verisim::cli
