#include "cli/commands/own_program.h"

#include "cli/settings/reading/ini.h"
#include "cli/settings/reading/scene_words.h"

namespace fs = std::filesystem;

namespace verisim::cli {

fs::path own_program() {
  std::error_code error;
  const fs::path path = fs::read_symlink("/proc/self/exe", error);
  if (error) throw std::runtime_error("cannot find the file of this program (/proc/self/exe)");
  return path;
}

SuiteWords suite_words(const std::vector<std::string>& words) {
  SuiteWords result;
  Options size;  // only to read +W and +H
  std::vector<std::string> switches;
  for (const std::string& word : with_folders(words)) {
    if (!is_setting_word(word)) {
      if (is_stream(word)) {
        Options stream;
        stream.input_file = word;
        result.spooled.push_back(std::make_unique<SpooledScene>(open_scene(stream)));
      }
      result.what.emplace_back(is_stream(word) ? result.spooled.back()->path() : fs::path(word));
      continue;
    }
    const std::size_t before = size.given.size();
    apply_argument(size, word);
    bool only_size = size.given.size() > before;
    for (std::size_t i = before; i < size.given.size(); ++i)
      only_size &= size.given[i].first == "Width" || size.given[i].first == "Height";
    if (!only_size) switches.push_back(word);
  }
  if (result.what.empty()) throw OptionError("name scenes, folders or manifests (verisim.toml)");
  result.defaults.width = size.width;
  result.defaults.height = size.height;
  if (!switches.empty()) result.defaults.switches = switches;
  if (!result.spooled.empty()) result.defaults.switches.push_back("+L" + fs::current_path().string());
  return result;
}

}  // namespace verisim::cli
