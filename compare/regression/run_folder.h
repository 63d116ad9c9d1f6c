// What a run leaves in RunOptions::work, so that it can be looked at and reviewed later, on another machine, too:
// run.json beside the pictures.
#pragma once

#include <filesystem>

#include "compare/compare.h"

namespace verisim::compare {

// The folder of stored pictures is remembered for the review; empty: there was none. Throws std::runtime_error.
void save_run(const Run& run, const std::filesystem::path& folder, const std::filesystem::path& baseline);

struct KeptRun {
  Run run;
  std::filesystem::path baseline;
};
// Pictures that went away are left out; nothing outside of the folder is looked at. Throws std::runtime_error.
KeptRun load_run(const std::filesystem::path& folder);

}  // namespace verisim::compare
