// Stored pictures of an earlier version in the place of the oracle.
#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/compare.h"
#include "compare/json_text.h"
#include "compare/regression/baseline.h"
#include "compare/regression/stored_variance.h"
#include "tracer/base/output_file.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

nlohmann::ordered_json read_list(const fs::path& folder) {
  nlohmann::ordered_json json;
  if (std::ifstream in(folder / "baseline.json"); in) json = parse_ordered_json(in);
  if (!json.is_object()) json = nlohmann::ordered_json::object();
  if (!json.contains("scenes") || !json["scenes"].is_object()) json["scenes"] = nlohmann::ordered_json::object();
  return json;
}

void forget(nlohmann::ordered_json& scenes, const std::string& name, const fs::path& folder) {
  const fs::path picture = fs::path(scenes[name].value("picture", "")).filename();  // nothing outside of the folder
  std::error_code ignored;
  if (!picture.empty()) fs::remove(folder / picture, ignored);
  scenes.erase(name);
}

void store_deviation(const fs::path& from, const fs::path& target) {
  if (const fs::path old = deviation_file(target); !old.empty()) fs::remove(old);
  const fs::path file = deviation_file(from);
  if (file.empty()) return;
  const std::string name = file.filename().string(), stem = from.stem().string();
  OutputFile out(target.parent_path() / (target.stem().string() + name.substr(stem.size())));
  copy_into(file, out.get());
  out.publish();
}

}  // namespace

std::vector<std::string> stored_scenes(const fs::path& baseline) {
  const nlohmann::ordered_json list = read_list(baseline);
  std::vector<std::string> names;
  for (const auto& [name, about] : list["scenes"].items()) names.push_back(name);
  return names;
}

std::string stored_call(const fs::path& baseline, const std::string& scene) {
  const nlohmann::ordered_json list = read_list(baseline);
  if (!list["scenes"].contains(scene)) return "";
  try {
    const auto& about = list["scenes"][scene];
    std::string switches;
    for (const std::string s : about.at("switches")) switches += " " + s;
    return fmt::format("; it was stored by {} with +W{} +H{}{}", about.at("version").get<std::string>(),
                       about.at("width").get<int>(), about.at("height").get<int>(), switches);
  } catch (const nlohmann::json::exception&) {
    return "";  // written by hand, or by another version
  }
}

std::vector<std::string> update_baseline(const Run& run, const fs::path& folder, bool dry_run,
                                         const std::map<std::string, std::string>& notes) {
  std::vector<std::string> changes;
  const fs::path list = folder / "baseline.json";
  nlohmann::ordered_json json = read_list(folder);
  if (!dry_run) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed)
      throw std::runtime_error(fmt::format("{}: cannot make the folder: {}", folder.string(), failed.message()));
  }
  for (const SceneResult& scene : run.scenes) {
    if (scene.status == Status::removed) {
      changes.push_back(fmt::format("{}: removed", scene.request.name));
      if (!dry_run) forget(json["scenes"], scene.request.name, folder);
      continue;
    }
    if (scene.native_picture.empty()) {
      changes.push_back(
          fmt::format("{}: kept as it is: {}: {}", scene.request.name, to_string(scene.status), scene.reason));
      continue;
    }
    if (scene.scene_class == SceneClass::stochastic && scene.passed() &&
        !deviation_file(folder / (scene.native_picture.stem().stem().string() + ".png")).empty())
      continue;  // one more run like those that are stored
    if (scene.metrics && scene.metrics->max_abs == 0 && scene.metrics->nan_pixels == 0 &&
        scene.metrics->alpha_max_abs.value_or(0) == 0)
      continue;
    changes.push_back(
        scene.metrics
            ? fmt::format("{}: changed: rmse {:.3f}, max {:.1f}, {:.3f} % within 1", scene.request.name,
                          scene.metrics->rmse, scene.metrics->max_abs, scene.metrics->within_1_pct)
            : fmt::format("{}: {}", scene.request.name, scene.status == Status::added ? "new" : scene.reason));
    if (dry_run) continue;
    // work/STEM.native.EXT -> DIR/STEM.EXT
    const fs::path extension = scene.native_picture.extension();
    const fs::path target = folder / (scene.native_picture.stem().stem().string() + extension.string());
    OutputFile file(target);
    copy_into(scene.native_picture, file.get());
    file.publish();
    store_deviation(scene.native_picture, target);
    json["scenes"][scene.request.name] = {{"picture", target.filename().string()},
                                          {"width", scene.request.width},
                                          {"height", scene.request.height},
                                          {"switches", scene.request.switches},
                                          {"version", run.native_version}};
    if (const auto note = notes.find(scene.request.name); note != notes.end() && !note->second.empty())
      json["scenes"][scene.request.name]["note"] = note->second;
  }
  if (!dry_run && !changes.empty()) {
    json["version"] = run.native_version;
    json["updated"] = run.started;
    write_report(json_text(json, 1) + "\n", list);
  }
  return changes;
}

}  // namespace verisim::compare
