// Which scenes: .pov files, folders of them, and manifests.
#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/json_text.h"
#include "compare/regression/suites/manifest.h"
#include "compare/report/json.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

constexpr const char* kManifestName = "verisim.toml";

void add_folder(const fs::path& folder, const std::string& prefix, const SuiteDefaults& defaults, Suite& suite) {
  if (fs::is_regular_file(folder / kManifestName)) {
    for (SceneRequest& scene : read_manifest(folder / kManifestName, defaults)) {
      scene.name = prefix + scene.name;
      suite.scenes.push_back(std::move(scene));
    }
    return;
  }
  for (const fs::directory_entry& entry : entries(folder)) {
    const std::string name = prefix + entry.path().filename().string();
    std::error_code failed;
    if (entry.is_directory(failed)) {
      if (!entry.is_symlink(failed)) add_folder(entry.path(), name + "/", defaults, suite);
    } else if (entry.is_regular_file(failed) && is_scene(entry.path())) {
      SceneRequest scene;
      scene.name = name, scene.scene = fs::absolute(entry.path()).lexically_normal();
      scene.width = defaults.width, scene.height = defaults.height, scene.switches = defaults.switches;
      suite.scenes.push_back(std::move(scene));
    }
  }
}

bool matches(const std::string& name, const std::string& wanted) {
  return name.find(wanted) != std::string::npos || fnmatch(wanted.c_str(), name.c_str(), 0) == 0;
}

std::set<std::string> failed_in(const fs::path& report) {
  std::ifstream in(report);
  if (!in) throw std::runtime_error(report.string() + ": cannot read the earlier report");
  const auto json = parse_json(in);
  std::set<std::string> out;
  try {
    for (const auto& scene : json.at("scenes"))
      if (const SceneResult result = scene_result_from_json(scene); result.failed()) out.insert(result.request.name);
  } catch (const nlohmann::json::exception&) {
    throw std::runtime_error(report.string() + ": not a report of verisim compare");
  }
  return out;
}

}  // namespace

Suite load_suite(const std::vector<fs::path>& what, const SuiteDefaults& defaults) {
  Suite suite;
  for (const fs::path& path : what) {
    if (fs::is_directory(path)) {
      const std::size_t before = suite.scenes.size();
      add_folder(path, "", defaults, suite);
      if (suite.scenes.size() == before) suite.warnings.push_back(path.string() + ": no scene in this folder");
    } else if (!fs::exists(path)) {
      throw std::runtime_error(path.string() + ": no such scene, manifest or folder");
    } else if (path.extension() == ".toml") {
      for (SceneRequest& scene : read_manifest(path, defaults)) suite.scenes.push_back(std::move(scene));
    } else {
      SceneRequest scene;
      scene.name = path.filename().string(), scene.scene = fs::absolute(path).lexically_normal();
      scene.width = defaults.width, scene.height = defaults.height, scene.switches = defaults.switches;
      suite.scenes.push_back(std::move(scene));
    }
  }
  std::map<std::string, int> seen;
  for (SceneRequest& scene : suite.scenes)
    if (const int n = ++seen[scene.name]; n > 1) scene.name += fmt::format(" ({})", n);
  return suite;
}

Suite filter(const Suite& suite, const Filter& f) {
  Suite out;
  out.warnings = suite.warnings;
  const std::set<std::string> failed = f.failed_last_time ? failed_in(f.last_report) : std::set<std::string>();
  for (const SceneRequest& scene : suite.scenes) {
    const bool name = f.names.empty() || std::any_of(f.names.begin(), f.names.end(),
                                                     [&](const std::string& n) { return matches(scene.name, n); });
    const bool tag = f.tags.empty() || std::any_of(f.tags.begin(), f.tags.end(), [&](const std::string& t) {
                       return std::find(scene.tags.begin(), scene.tags.end(), t) != scene.tags.end();
                     });
    if (name && tag && (!f.failed_last_time || failed.contains(scene.name))) out.scenes.push_back(scene);
  }
  return out;
}

}  // namespace verisim::compare
