// Frames that share one parsed scene: an animation of a scene that never looks at the clock (its pictures may differ by
// settings) is parsed once.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "parser/parse.h"

namespace verisim::cli {

// True if parsing these files again could give something else for another frame, or do something (messages, files
// written) that every frame of POV-Ray's does: any of them holds a word for the clock, the frame, messages, files or
// the time. Comments and strings count, too.
// `text`: a scene that is no file.
bool depends_on_frame(const std::vector<std::filesystem::path>& files, const std::optional<std::string>& text);

// What the first frame leaves for the others; empty: each parses for itself.
struct SharedScene {
  parser::ParseResult result;
};

}  // namespace verisim::cli
