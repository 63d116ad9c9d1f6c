// Where POV-Ray's standard include files (colors.inc, textures.inc ...) are installed.
#pragma once

#include <filesystem>
#include <vector>

namespace verisim::parser {

// The folders of the environment's VERISIM_INCLUDE_PATH (separated by colons), then those that exist of where packages
// put the standard include files.
std::vector<std::filesystem::path> standard_include_folders();

}  // namespace verisim::parser
