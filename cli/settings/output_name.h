// Where scenes are found and pictures go (spec 02 section 9.5).
#pragma once

#include <filesystem>
#include <string>

#include "cli/settings/animation.h"
#include "cli/settings/options.h"

namespace verisim::cli {

// The scene's file: in the current folder, then in the library paths, with .pov or .POV appended where needed. Empty if
// there is none.
std::filesystem::path find_scene(const Options& options);

struct OutputName {
  bool standard_output = false, standard_error = false;
  std::filesystem::path path;        // with frame number and extension
  std::filesystem::path state_path;  // of continue-trace
};

// `frame` counts only when the animation is on.
OutputName output_name(const Options& options, const std::filesystem::path& scene, const Animation& animation,
                       const Frame& frame);

}  // namespace verisim::cli
