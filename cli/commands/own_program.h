// What `compare` and `bench` share: this program's own path, and their command lines.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/settings/scene_source.h"
#include "compare/compare.h"

namespace verisim::cli {

// The file this process runs from.
std::filesystem::path own_program();

// Paths to work on, and switches for all of them. +W and +H are taken out as the default size.
struct SuiteWords {
  std::vector<std::filesystem::path> what;
  compare::SuiteDefaults defaults;
  std::vector<std::unique_ptr<SpooledScene>> spooled;  // the files of scenes that came through streams
};
SuiteWords suite_words(const std::vector<std::string>& words);  // throws OptionError

}  // namespace verisim::cli
