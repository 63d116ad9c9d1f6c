// Two pictures as a run of one scene, for the reports of `verisim diff`.
#include <nlohmann/json.hpp>

#include "compare/compare.h"
#include "compare/json_text.h"
#include "compare/oracle/working_copy.h"
#include "compare/report/display.h"
#include "compare/report/json.h"

namespace verisim::compare {
namespace {

// The report shows what was measured: the fitted pictures, in a folder that goes with the run.
void show_fitted(const FittedPair& fitted, Run& run) {
  auto folder = std::make_shared<TemporaryFolder>();
  SceneResult& scene = run.scenes.front();
  scene.oracle_picture = folder->path() / "reference.png", scene.native_picture = folder->path() / "test.png";
  image::write_picture(displayable(fitted.reference), scene.oracle_picture);
  image::write_picture(displayable(fitted.test), scene.native_picture);
  run.keep = folder;
}

}  // namespace

Run run_of_pair(const Pair& pair) {
  Run run;
  run.reference_name = pair.reference.filename().string(), run.test_name = pair.test.filename().string();
  if (run.reference_name == run.test_name)
    run.reference_name = pair.reference.string(), run.test_name = pair.test.string();
  SceneResult& s = run.scenes.emplace_back();
  s.metrics = pair.metrics, s.layers = pair.layers;
  s.status = pair.verdict.status, s.reason = pair.verdict.reason;
  s.request.name = run.reference_name + " – " + run.test_name;
  s.request.width = pair.metrics.width, s.request.height = pair.metrics.height;
  s.oracle_picture = pair.reference, s.native_picture = pair.test;
  if (pair.fitted) s.fit = pair.fitted->fit, show_fitted(*pair.fitted, run);
  if (s.status == Status::differ && reduction(pair.metrics.width, pair.metrics.height) == 1)
    s.suspicions = pair.fitted ? diagnose(pair.fitted->reference, pair.fitted->test)
                               : diagnose(image::read_picture(pair.reference), image::read_picture(pair.test));
  run.summary = summarise(run.scenes);
  return run;
}

Run run_of_pair(const std::filesystem::path& reference, const std::filesystem::path& test,
                const MetricOptions& options) {
  const Metrics metrics = measure_files(reference, test, options);
  const Layers layers = compare_layers(reference, test, {}, false);
  return run_of_pair(
      {reference, test, metrics, with_layers(judge_deterministic(metrics, false), layers), layers.all, {}});
}

std::string pair_json(const Run& run) {
  const SceneResult& scene = run.scenes.at(0);
  const nlohmann::json whole = to_json(scene);
  nlohmann::ordered_json json = parse_ordered_json(metrics_json(*scene.metrics));
  json["reference"] = run.reference_name, json["test"] = run.test_name;
  for (const char* part : {"status", "reason", "layers", "suspects", "fit"})
    if (whole.contains(part)) json[part] = whole[part];
  return json_text(json, 2) + "\n";
}

}  // namespace verisim::compare
