// Which scene a file is a part of.
#pragma once

#include <filesystem>

namespace verisim::cli {

// A scene (*.pov, another than the file) in the file's folder or the one above that names it behind `#include`; empty:
// none is found. Absolute.
std::filesystem::path scene_that_includes(const std::filesystem::path& file);

}  // namespace verisim::cli
