// DF3 voxel files of `density_file` (spec 05 section 8).
#pragma once

#include <filesystem>

#include "tracer/scene/pattern.h"

namespace verisim {

// Three big-endian 16-bit sizes, then samples of 1, 2 or 4 bytes (from the file's length). Throws std::runtime_error
// with a message for users.
scene::DensityFileParams load_density_file(const std::filesystem::path& path);

}  // namespace verisim
