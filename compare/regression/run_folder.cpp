#include "compare/regression/run_folder.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/json_text.h"
#include "compare/report/json.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

constexpr std::pair<const char*, fs::path SceneResult::*> kPictures[] = {{"oracle", &SceneResult::oracle_picture},
                                                                         {"native", &SceneResult::native_picture},
                                                                         {"judged", &SceneResult::judged_picture},
                                                                         {"p_map", &SceneResult::p_map}};

Json kept(const SceneResult& s) {
  Json json;
  json["file"] = s.request.scene.string(), json["switches"] = s.request.switches;
  json["pixels_per_degree"] = s.request.flip_pixels_per_degree;
  for (const auto& [name, member] : kPictures)
    if (!(s.*member).empty()) json["pictures"][name] = (s.*member).filename().string();
  for (const PixelTags::Tree& tree : s.trees)
    json["trees"].push_back({{"x", tree.x}, {"y", tree.y}, {"text", tree.text}});
  if (s.metrics) {
    json["histogram"] = s.metrics->histogram;
    for (const WorstPixel& p : s.metrics->worst) json["worst"].push_back({p.x, p.y, p.error});
  }
  return json;
}

void take(const Json& json, const fs::path& folder, SceneResult& s) {
  s.request.scene = json.value("file", ""), s.request.switches = json.value("switches", std::vector<std::string>());
  s.request.flip_pixels_per_degree = json.value("pixels_per_degree", s.request.flip_pixels_per_degree);
  const Json pictures = json.value("pictures", Json::object());
  for (const auto& [name, member] : kPictures) {
    const fs::path file = fs::path(pictures.value(name, "")).filename();
    if (!file.empty() && fs::is_regular_file(folder / file)) s.*member = folder / file;
  }
  for (const Json& tree : json.value("trees", Json::array()))
    s.trees.push_back({tree.at("x"), tree.at("y"), tree.at("text")});
  if (!s.metrics) return;
  s.metrics->histogram = json.value("histogram", s.metrics->histogram);
  for (const Json& p : json.value("worst", Json::array()))
    s.metrics->worst.push_back({p.at(0), p.at(1), p.at(2), {}, {}});
}

}  // namespace

void save_run(const Run& run, const fs::path& folder, const fs::path& baseline) {
  Json json = parse_json(json_report(run));
  json["baseline"] = baseline.empty() ? "" : fs::absolute(baseline).lexically_normal().string();
  json["test"] = run.test_name;
  for (std::size_t i = 0; i < run.scenes.size(); ++i) json["scenes"][i]["kept"] = kept(run.scenes[i]);
  write_report(json_text(json, 1) + "\n", folder / "run.json");
}

KeptRun load_run(const fs::path& folder) {
  const fs::path file = folder / "run.json";
  std::ifstream in(file);
  if (!in)
    throw std::runtime_error(file.string() + ": there is no run here; `verisim compare ... --work FOLDER` keeps one");
  const Json json = parse_json(in);
  KeptRun out;
  try {
    for (const Json& scene : json.at("scenes")) {
      SceneResult& s = out.run.scenes.emplace_back(scene_result_from_json(scene));
      s.request.tags = scene.value("tags", std::vector<std::string>());
      s.request.known_failure = scene.value("known_failure", "");
      take(scene.value("kept", Json::object()), folder, s);
    }
    out.run.reference_name = json.value("reference", out.run.reference_name);
    out.run.test_name = json.value("test", out.run.test_name);
    out.run.oracle_version = json.value("oracle_version", ""),
    out.run.native_version = json.value("native_version", "");
    out.run.started = json.value("started", ""), out.run.cancelled = json.value("cancelled", false);
    out.baseline = json.value("baseline", "");
  } catch (const Json::exception& error) {
    throw std::runtime_error(file.string() + ": not a run of verisim compare: " + error.what());
  }
  out.run.summary = summarise(out.run.scenes);
  return out;
}

}  // namespace verisim::compare
