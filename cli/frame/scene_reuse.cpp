#include "cli/frame/scene_reuse.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <string>
#include <string_view>

#include "tracer/base/whole_file.h"

namespace verisim::cli {
namespace {

constexpr auto kWords =
    std::to_array<std::string_view>({"clock", "clock_delta", "clock_on", "debug", "error", "file_exists", "final_clock",
                                     "final_frame", "fopen", "frame_number", "initial_clock", "initial_frame",
                                     "load_file", "now", "render", "save_file", "statistics", "warning"});

bool holds_word(const std::string& text) {
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t i = 0; i < text.size();) {
    if (!in_word(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && in_word(text[end])) ++end;
    if (std::binary_search(kWords.begin(), kWords.end(), std::string_view(text).substr(i, end - i))) return true;
    i = end;
  }
  return false;
}

}  // namespace

bool depends_on_frame(const std::vector<std::filesystem::path>& files, const std::optional<std::string>& text) {
  if (text && holds_word(*text)) return true;
  for (const std::filesystem::path& file : files) {
    const std::optional<std::string> content = whole_file(file);
    if (!content || holds_word(*content)) return true;
  }
  return files.empty() && !text;
}

}  // namespace verisim::cli
