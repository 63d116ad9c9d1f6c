#include "parser/source/standard_includes.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace verisim::parser {
namespace fs = std::filesystem;

std::vector<fs::path> standard_include_folders() {
  std::vector<fs::path> folders;
  const auto add = [&](const fs::path& path) {
    if (!path.empty() && std::find(folders.begin(), folders.end(), path) == folders.end()) folders.push_back(path);
  };
  const char* variable = std::getenv("VERISIM_INCLUDE_PATH");
  const std::string extra = variable ? variable : "";
  for (std::size_t start = 0; !extra.empty() && start <= extra.size();) {
    const std::size_t end = std::min(extra.find(':', start), extra.size());
    add(extra.substr(start, end - start));
    start = end + 1;
  }
  for (const char* known :
       {VERISIM_DEFAULT_INCLUDE_DIR, "/usr/share/povray-3.7/include", "/usr/local/share/povray-3.7/include",
        "/usr/share/povray/include", "/opt/homebrew/share/povray-3.7/include"}) {
    std::error_code ignored;
    if (*known && fs::is_directory(known, ignored)) add(known);
  }
  return folders;
}

}  // namespace verisim::parser
