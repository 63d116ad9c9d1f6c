#include "cli/describe/including_scene.h"

#include <algorithm>
#include <vector>

#include "parser/source/suggest.h"
#include "tracer/base/whole_file.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

constexpr std::size_t kMaxScenes = 200;        // of a folder
constexpr std::uintmax_t kLargest = 1u << 20;  // bytes of a scene that is looked into

std::vector<fs::path> scenes_in(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> scenes;
  for (fs::directory_iterator i(folder, failed), end; !failed && i != end && scenes.size() < kMaxScenes;
       i.increment(failed))
    if (parser::lowered(i->path().extension().string()) == ".pov") scenes.push_back(i->path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

// Whether a text has "NAME" or a path that ends in it between quotes.
bool names(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name + '"'); at != std::string::npos; at = text.find(name + '"', at + 1))
    if (at > 0 && (text[at - 1] == '"' || text[at - 1] == '/' || text[at - 1] == '\\')) return true;
  return false;
}

}  // namespace

fs::path scene_that_includes(const fs::path& file) {
  std::error_code failed;
  const fs::path own = fs::absolute(file, failed).lexically_normal();
  fs::path folder = own.parent_path();
  for (int level = 0; level < 2 && !failed; ++level, folder = folder.parent_path())
    for (const fs::path& scene : scenes_in(folder)) {
      if (scene == own || fs::file_size(scene, failed) > kLargest || failed) continue;
      if (names(whole_file(scene).value_or(""), own.filename().string())) return scene;
    }
  return {};
}

}  // namespace verisim::cli
