// Stored pictures of an earlier version in the place of the oracle.
#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/compare.h"
#include "tracer/base/output_file.h"

namespace verisim::compare {
namespace fs = std::filesystem;

std::vector<std::string> update_baseline(const Run& run, const fs::path& folder, bool dry_run) {
  std::vector<std::string> changes;
  const fs::path list = folder / "baseline.json";
  nlohmann::ordered_json json;
  if (std::ifstream in(list); in) json = nlohmann::ordered_json::parse(in, nullptr, false);
  if (!json.is_object()) json = nlohmann::ordered_json::object();
  if (!dry_run) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed)
      throw std::runtime_error(fmt::format("{}: cannot make the folder: {}", folder.string(), failed.message()));
  }
  for (const SceneResult& scene : run.scenes) {
    if (scene.native_picture.empty()) {
      changes.push_back(
          fmt::format("{}: kept as it is: {}: {}", scene.request.name, to_string(scene.status), scene.reason));
      continue;
    }
    if (scene.metrics && scene.metrics->max_abs == 0 && scene.metrics->nan_pixels == 0 &&
        scene.metrics->alpha_max_abs.value_or(0) == 0)
      continue;
    changes.push_back(
        scene.metrics
            ? fmt::format("{}: changed: rmse {:.3f}, max {:.1f}, {:.3f} % within 1", scene.request.name,
                          scene.metrics->rmse, scene.metrics->max_abs, scene.metrics->within_1_pct)
            : fmt::format("{}: {}", scene.request.name, scene.status == Status::oracle_failed ? "new" : scene.reason));
    if (dry_run) continue;
    // work/STEM.native.EXT -> DIR/STEM.EXT
    const fs::path extension = scene.native_picture.extension();
    const fs::path target = folder / (scene.native_picture.stem().stem().string() + extension.string());
    OutputFile file(target);
    copy_into(scene.native_picture, file.get());
    file.publish();
    json["scenes"][scene.request.name] = {{"picture", target.filename().string()},
                                          {"width", scene.request.width},
                                          {"height", scene.request.height},
                                          {"switches", scene.request.switches},
                                          {"version", run.native_version}};
  }
  if (!dry_run && !changes.empty()) {
    json["version"] = run.native_version;
    json["updated"] = run.started;
    write_report(json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n", list);
  }
  return changes;
}

}  // namespace verisim::compare
