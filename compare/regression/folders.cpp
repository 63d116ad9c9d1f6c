#include "compare/regression/folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compare/report/display.h"
#include "compare/report/json.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

bool is_picture(const fs::path& path) {
  static const std::set<std::string> kExtensions{".png", ".jpg", ".jpeg", ".exr", ".hdr", ".ppm", ".pgm",
                                                 ".pam", ".pfm", ".tga",  ".bmp", ".tif", ".tiff"};
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return kExtensions.contains(extension);
}

std::set<std::string> pictures_below(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (is_picture(entry.path()) && entry.is_regular_file())
      names.insert(entry.path().lexically_relative(folder).generic_string());
  return names;
}

void compare_pair(const fs::path& reference, const fs::path& test, const FolderOptions& options, SceneResult& out) {
  out.oracle_picture = reference, out.native_picture = test;
  try {
    out.metrics = measure_files(reference, test, options.metric);
    const Layers layers = compare_layers(reference, test, options.layers, options.antialiased);
    out.layers = layers.all;
    const Verdict verdict =
        with_layers(options.thresholds.empty() ? judge_deterministic(*out.metrics, options.antialiased)
                                               : judge_thresholds(*out.metrics, options.thresholds),
                    layers);
    out.status = verdict.status, out.reason = verdict.reason;
    out.request.width = out.metrics->width, out.request.height = out.metrics->height;
    if (out.status == Status::differ && reduction(out.metrics->width, out.metrics->height) == 1)
      out.suspicions = diagnose(image::read_picture(reference), image::read_picture(test));
  } catch (const PictureMismatch& mismatch) {
    out.status = Status::differ, out.reason = mismatch.what();
  } catch (const std::runtime_error& error) {
    out.status = Status::error, out.reason = error.what();
  }
}

}  // namespace

Run run_of_folders(const fs::path& reference, const fs::path& test, const FolderOptions& options) {
  if (!options.thresholds.empty()) judge_thresholds(Metrics{}, options.thresholds);  // throws before the long work
  const std::set<std::string> references = pictures_below(reference), tests = pictures_below(test);
  std::set<std::string> names = references;
  names.insert(tests.begin(), tests.end());
  if (names.empty())
    throw std::runtime_error(fmt::format("there is no picture below {} or {}", reference.string(), test.string()));
  Run run;
  run.reference_name = reference.string(), run.test_name = test.string();
  for (const std::string& name : names) {
    SceneResult& scene = run.scenes.emplace_back();
    scene.request.name = name, scene.request.scene = test / name;
    if (!references.contains(name)) {
      scene.status = Status::added, scene.native_picture = test / name, scene.reason = "not in " + reference.string();
    } else if (!tests.contains(name)) {
      scene.status = Status::removed, scene.oracle_picture = reference / name, scene.reason = "not in " + test.string();
    } else {
      compare_pair(reference / name, test / name, options, scene);
    }
  }
  run.summary = summarise(run.scenes);
  return run;
}

}  // namespace verisim::compare
