#include "cli/settings/reading/configuration.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "cli/settings/reading/ini.h"
#include "parser/source/standard_includes.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

bool exists(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

}  // namespace

void apply_configuration(Options& options) {
  std::vector<fs::path> candidates;
  if (const std::string named = environment("POVINI"); !named.empty()) {
    if (exists(named))
      candidates.emplace_back(named);
    else
      options.notes.push_back(fmt::format("POVINI environment: cannot open '{}'", named));
  }
  const std::string home = environment("HOME");
  candidates.emplace_back("./povray.ini");
  if (!home.empty()) candidates.emplace_back(fs::path(home) / ".povray/3.7/povray.ini");
  candidates.emplace_back("/etc/povray/3.7/povray.ini");
  candidates.emplace_back("/usr/local/etc/povray/3.7/povray.ini");
  if (!home.empty()) candidates.emplace_back(fs::path(home) / ".povrayrc");
  candidates.emplace_back("/etc/povray.ini");
  const auto found = std::find_if(candidates.begin(), candidates.end(), exists);
  if (found != candidates.end()) apply_ini_file(options, found->string());
  options.given.clear();  // Create_Ini writes what the user set
}

std::vector<fs::path> search_paths(const Options& options, const fs::path& scene) {
  std::vector<fs::path> paths(options.library_paths.begin(), options.library_paths.end());
  const auto add = [&](const fs::path& path) {
    if (!path.empty() && std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
  };
  add(environment("POVINC"));
  add(scene.parent_path());
  for (const fs::path& folder : parser::standard_include_folders()) add(folder);
  return paths;
}

}  // namespace verisim::cli
