// povray.ini, environment variables and the places where include files are found (spec 02 section 9.1).
#pragma once

#include <filesystem>
#include <vector>

#include "cli/settings/options.h"

namespace verisim::cli {

// Applies the first povray.ini that exists. Throws OptionError when it cannot be understood.
void apply_configuration(Options& options);

// After all arguments: the folders the parser searches after the current one, in order. These are POV-Ray's
// (Library_Path, POVINC), then the scene's own folder, VERISIM_INCLUDE_PATH (colon-separated) and the places where
// packages put the standard include files.
std::vector<std::filesystem::path> search_paths(const Options& options, const std::filesystem::path& scene);

}  // namespace verisim::cli
