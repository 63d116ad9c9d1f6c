// Parts of a picture put together: the file that one render of the whole picture would have written, to the byte.
#pragma once

#include <atomic>
#include <filesystem>
#include <vector>

namespace verisim::cli {

struct Merged {
  int parts = 0;
  int width = 0, height = 0;
};

// Of the parts no more is in memory than a row of blocks (and what the picture's format needs). Throws OptionError, or
// std::runtime_error when parts are missing, doubled, damaged or of different pictures, naming them; then nothing is
// written; the same with `stop`, once it is true.
Merged merge_parts(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& output,
                   const std::atomic<bool>& stop);

}  // namespace verisim::cli
