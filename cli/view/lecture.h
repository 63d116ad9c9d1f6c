// The lecture's pages (docs/lecture), whose scenes can be changed and drawn, and whose pixels can be asked.
#pragma once

#include <filesystem>

#include "cli/console/interrupt.h"
#include "cli/settings/options.h"
#include "cli/view/server.h"

namespace verisim::cli {

// The folder of the pages: of this installation, or of the source tree that it was built from. Throws
// std::runtime_error where there is none.
std::filesystem::path lecture_folder();
// The scenes that the pages of a folder show.
std::filesystem::path lecture_scenes(const std::filesystem::path& folder);

// Answers for all files of `folder`; and to `draw` and `pixel`, which take the text of a scene. These must outlive the
// server.
void serve_lecture(Server& server, const std::filesystem::path& folder, const Options& options, Interrupt& interrupt);

}  // namespace verisim::cli
