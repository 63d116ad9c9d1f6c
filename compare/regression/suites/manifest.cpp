#include "compare/regression/suites/manifest.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>

#include "compare/oracle/switches.h"
#include "compare/regression/suites/toml.h"

namespace verisim::compare {
namespace fs = std::filesystem;

bool is_scene(const fs::path& path) {
  const std::string e = path.extension().string();
  return e == ".pov" || e == ".POV" || e == ".Pov";
}

std::vector<fs::directory_entry> entries(const fs::path& folder) {
  std::vector<fs::directory_entry> out;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, fs::directory_options::skip_permission_denied))
    if (!entry.path().filename().string().starts_with(".")) out.push_back(entry);
  std::sort(out.begin(), out.end());
  return out;
}

namespace {

constexpr int kMaxSide = 1 << 20;

void scenes_below(const fs::path& folder, std::vector<fs::path>& out, bool any = false) {
  for (const fs::directory_entry& entry : entries(folder)) {
    std::error_code failed;
    if (entry.is_directory(failed) && !entry.is_symlink(failed))
      scenes_below(entry.path(), out, any);
    else if (entry.is_regular_file(failed) && (any || is_scene(entry.path())))
      out.push_back(entry.path());
  }
}

// Reads the keys that a manifest's head (defaults of its scenes) and its [[scene]] tables have in common.
class Manifest {
 public:
  Manifest(const fs::path& file, const SuiteDefaults& defaults)
      : file_(file), folder_(fs::absolute(file).parent_path()) {
    default_.width = defaults.width, default_.height = defaults.height, default_.switches = defaults.switches;
  }

  std::vector<SceneRequest> read() {
    toml::table table;
    try {
      table = toml::parse_file(file_.string());
    } catch (const toml::parse_error& error) {
      fail(error.source(), std::string(error.description()));
    }
    const toml::node* scenes = nullptr;
    for (auto&& [key, node] : table) {
      if (key == "scene")
        scenes = &node;
      else
        common(std::string(key.str()), node, default_);
    }
    if (!scenes) return whole_folder();
    const toml::array* array = scenes->as_array();
    if (!array) fail(scenes->source(), "'scene' must be written as [[scene]]");
    std::vector<SceneRequest> out;
    for (const toml::node& node : *array) {
      if (!node.is_table()) fail(node.source(), "'scene' must be written as [[scene]]");
      one(*node.as_table(), out);
    }
    return out;
  }

 private:
  [[noreturn]] void fail(const toml::source_region& where, const std::string& what) const {
    throw std::runtime_error(
        fmt::format("{}:{}:{}: error: {}", file_.string(), where.begin.line, where.begin.column, what));
  }

  template <typename T>
  T get(const toml::node& node, const std::string& key, const char* type) const {
    const auto value = node.value_exact<T>();
    if (!value) fail(node.source(), fmt::format("'{}' must be {}", key, type));
    return *value;
  }
  std::string text(const toml::node& node, const std::string& key) const {
    return get<std::string>(node, key, "a string");
  }
  double number(const toml::node& node, const std::string& key) const {
    const auto value = node.value<double>();
    if (!value || !node.is_number()) fail(node.source(), fmt::format("'{}' must be a number", key));
    return *value;
  }
  std::vector<std::string> texts(const toml::node& node, const std::string& key) const {
    const toml::array* array = node.as_array();
    if (!array) fail(node.source(), fmt::format("'{}' must be an array of strings", key));
    std::vector<std::string> out;
    for (const toml::node& item : *array) out.push_back(text(item, key));
    return out;
  }
  int side(const toml::node& node, const std::string& key) const {
    const auto value = get<std::int64_t>(node, key, "a whole number");
    if (value < 1 || value > kMaxSide) fail(node.source(), fmt::format("'{}' must be between 1 and {}", key, kMaxSide));
    return static_cast<int>(value);
  }

  void passes(const toml::node& node, SceneRequest& out) const {
    const toml::array* array = node.as_array();
    if (!array || array->empty()) fail(node.source(), "'passes' must be an array of { switches, matrix }");
    for (const toml::node& item : *array) {
      const toml::table* table = item.as_table();
      if (!table) fail(item.source(), "'passes' must be an array of { switches, matrix }");
      SceneRequest switched;
      Pass pass;
      bool has_matrix = false;
      for (auto&& [key, value] : *table) {
        if (key == "switches")
          switches(value, switched);
        else if (key == "matrix")
          pass.matrix = matrix(value), has_matrix = true;
        else
          fail(value.source(), fmt::format("unknown key '{}' of a pass", std::string(key.str())));
      }
      if (!has_matrix) fail(item.source(), "a pass needs a 'matrix'");
      pass.switches = switched.switches;
      out.passes.push_back(std::move(pass));
    }
  }
  std::array<std::array<double, 3>, 3> matrix(const toml::node& node) const {
    std::array<std::array<double, 3>, 3> out{};
    const toml::array* rows = node.as_array();
    for (std::size_t i = 0; i < 3; ++i) {
      const toml::array* row = rows && rows->size() == 3 ? (*rows)[i].as_array() : nullptr;
      if (!row || row->size() != 3) fail(node.source(), "'matrix' must be three rows of three numbers");
      for (std::size_t j = 0; j < 3; ++j) out[i][j] = number((*row)[j], "matrix");
    }
    return out;
  }

  void common(const std::string& key, const toml::node& node, SceneRequest& out) const {
    if (key == "width")
      out.width = side(node, key);
    else if (key == "height")
      out.height = side(node, key);
    else if (key == "switches")
      switches(node, out);
    else if (key == "tags")
      out.tags = texts(node, key);
    else if (key == "class")
      scene_class(node, out);
    else if (key == "thresholds")
      thresholds(node, out);
    else if (key == "allow")
      allow(node, out);
    else if (key == "fail")
      fail_limits(node, out);
    else if (key == "warn")
      out.warnings = limits(node, key);
    else if (key == "ignore")
      ignore(node, out);
    else if (key == "layers")
      layers(node, out);
    else if (key == "known_failure")
      out.known_failure = text(node, key);
    else if (key == "crop")
      crop(node, out);
    else if (key == "corners")
      corners(node, out);
    else if (key == "targets")
      targets(node, out);
    else if (key == "fit")
      fit(node, out);
    else if (key == "beside")
      out.beside = texts(node, key);
    else if (key == "pixels_per_degree")
      out.flip_pixels_per_degree = number(node, key);
    else
      fail(node.source(), fmt::format("unknown key '{}'", key));
  }
  void switches(const toml::node& node, SceneRequest& out) const {
    if (node.is_array()) {
      out.switches = texts(node, "switches");
      return;
    }
    try {
      out.switches = split_switches(text(node, "switches"));
    } catch (const std::invalid_argument& error) {
      fail(node.source(), error.what());
    }
  }
  void scene_class(const toml::node& node, SceneRequest& out) const {
    const std::string value = text(node, "class");
    if (value == "auto")
      out.scene_class.reset();
    else if (value == "deterministic")
      out.scene_class = SceneClass::deterministic;
    else if (value == "stochastic")
      out.scene_class = SceneClass::stochastic;
    else
      fail(node.source(), "'class' must be \"auto\", \"deterministic\" or \"stochastic\"");
  }
  void thresholds(const toml::node& node, SceneRequest& out) const {
    const toml::table* table = node.as_table();
    if (!table) fail(node.source(), "'thresholds' must be a table like {max_rmse = 1.0}");
    out.thresholds.clear();
    for (auto&& [key, value] : *table) {
      const std::string name(key.str());
      try {
        judge_thresholds(Metrics{}, {{name, 0}});
      } catch (const std::invalid_argument& error) {
        fail(value.source(), error.what());
      }
      out.thresholds[name] = number(value, name);
    }
  }

  void allow(const toml::node& node, SceneRequest& out) const {
    const toml::table* table = node.as_table();
    if (!table) fail(node.source(), "'allow' must be a table like {solid_pixels = 10, drift_max = 0.5}");
    out.allowed = {};
    for (auto&& [key, value] : *table) {
      if (key == "solid_pixels")
        out.allowed.solid_pixels = number(value, "solid_pixels");
      else if (key == "drift_max")
        out.allowed.drift_max = number(value, "drift_max");
      else if (key == "one_sided_pixels")
        out.allowed.one_sided_pixels = number(value, "one_sided_pixels");
      else if (key == "leaning")
        out.allowed.leaning = number(value, "leaning");
      else
        fail(value.source(),
             fmt::format(
                 "unknown key '{}' of 'allow': it may hold solid_pixels, drift_max, one_sided_pixels and leaning",
                 std::string(key.str())));
    }
  }

  // Limits on figures, and on every pixel by itself.
  Limits limits(const toml::node& node, const std::string& key) const {
    const toml::table* table = node.as_table();
    if (!table)
      fail(
          node.source(),
          fmt::format("'{}' must be a table like {{max_rmse = 1.0, absolute = 2, relative = 0.01, pixels = 10}}", key));
    Limits out;
    for (auto&& [k, value] : *table) {
      const std::string name(k.str());
      const double limit = number(value, name);
      if (name == "absolute" || name == "relative" || name == "pixels") {
        if (!(limit >= 0) || limit > 1e15) fail(value.source(), fmt::format("'{}' must not be negative", name));
        if (!out.pixels) out.pixels.emplace();
        if (name == "absolute")
          out.pixels->absolute = limit;
        else if (name == "relative")
          out.pixels->relative = limit;
        else
          out.pixels->pixels = static_cast<std::uint64_t>(limit);
        continue;
      }
      try {
        judge_thresholds(Metrics{}, {{name, 0}});
      } catch (const std::invalid_argument& error) {
        fail(value.source(), std::string(error.what()) + "; or it is absolute, relative or pixels");
      }
      out.figures[name] = limit;
    }
    return out;
  }
  void fail_limits(const toml::node& node, SceneRequest& out) const {
    const Limits given = limits(node, "fail");
    out.thresholds = given.figures, out.pixel_limits = given.pixels;
  }

  void ignore(const toml::node& node, SceneRequest& out) const {
    const toml::table* table = node.as_table();
    if (!table)
      fail(
          node.source(),
          "'ignore' must be a table like {rectangles = [[x, y, width, height]], mask = \"mask.png\", objects = [\"text "
          "(room.pov:7)\"]}");
    out.ignored = {};
    for (auto&& [k, value] : *table) {
      const std::string key(k.str());
      if (key == "rectangles")
        rectangles(value, out.ignored);
      else if (key == "mask")
        out.ignored.mask = folder_ / text(value, key);
      else if (key == "objects")
        out.ignored.objects = texts(value, key);
      else
        fail(value.source(),
             fmt::format("unknown key '{}' of 'ignore': it may hold rectangles, mask and objects", key));
    }
  }
  void rectangles(const toml::node& node, Ignored& out) const {
    const toml::array* array = node.as_array();
    if (!array) fail(node.source(), "'rectangles' must be an array of [x, y, width, height]");
    for (const toml::node& item : *array) {
      const std::vector<double> v = numbers(item, "rectangles", 4, 4);
      for (const double x : v)
        if (x != std::floor(x) || x < 0 || x > kMaxSide)
          fail(item.source(), "a rectangle is four whole numbers: x, y, width and height");
      out.rectangles.push_back(
          {static_cast<int>(v[0]), static_cast<int>(v[1]), static_cast<int>(v[2]), static_cast<int>(v[3])});
    }
  }

  void layers(const toml::node& node, SceneRequest& out) const {
    out.layers.clear();
    try {
      for (const std::string& rule : texts(node, "layers")) out.layers.push_back(layer_rule(rule));
    } catch (const std::invalid_argument& error) {
      fail(node.source(), error.what());
    }
  }

  // One picture, or several that are as good: of other platforms, say.
  void references(const toml::node& node, SceneRequest& out) const {
    if (!node.is_array()) {
      out.reference = folder_ / text(node, "reference");
      return;
    }
    out.alternatives.clear();
    for (const std::string& name : texts(node, "reference")) out.alternatives.push_back(folder_ / name);
    if (out.alternatives.empty()) fail(node.source(), "'reference' names no picture");
    out.reference = out.alternatives.front();
    out.alternatives.erase(out.alternatives.begin());
  }

  std::vector<double> numbers(const toml::node& node, const std::string& key, std::size_t least,
                              std::size_t most) const {
    const toml::array* array = node.as_array();
    if (!array || array->size() < least || array->size() > most)
      fail(node.source(), fmt::format("'{}' must be an array of {} numbers", key, most));
    std::vector<double> out;
    for (const toml::node& item : *array) out.push_back(number(item, key));
    return out;
  }
  void crop(const toml::node& node, SceneRequest& out) const {
    const std::vector<double> v = numbers(node, "crop", 4, 4);
    for (double x : v)
      if (x != std::floor(x) || x < 0 || x > kMaxSide)
        fail(node.source(), "'crop' must be four whole numbers: x, y, width and height in the reference");
    if (v[2] < 1 || v[3] < 1) fail(node.source(), "'crop' must have a width and a height of at least 1");
    out.fit.crop = Crop{static_cast<int>(v[0]), static_cast<int>(v[1]), static_cast<int>(v[2]), static_cast<int>(v[3])};
  }
  void corners(const toml::node& node, SceneRequest& out) const {
    const toml::array* array = node.as_array();
    if (!array || array->size() != 4)
      fail(node.source(), "'corners' must be four points [x, y] of the reference, from the upper left one clockwise");
    out.fit.corners.emplace();
    for (std::size_t i = 0; i < 4; ++i) {
      const std::vector<double> v = numbers((*array)[i], "corners", 2, 2);
      (*out.fit.corners)[i] = {v[0], v[1]};
    }
  }
  void targets(const toml::node& node, SceneRequest& out) const {
    out.fit.targets.clear();
    for (const std::string& text : texts(node, "targets")) {
      try {
        out.fit.targets.push_back(color_target_of(text));
      } catch (const std::invalid_argument& error) {
        fail(node.source(), error.what());
      }
    }
  }
  void fit(const toml::node& node, SceneRequest& out) const {
    out.fit.exposure = out.fit.white_balance = out.fit.distortion = out.fit.vignetting = false;
    for (const std::string& what : texts(node, "fit")) {
      if (what == "exposure")
        out.fit.exposure = true;
      else if (what == "white_balance")
        out.fit.white_balance = true;
      else if (what == "distortion")
        out.fit.distortion = true;
      else if (what == "vignetting")
        out.fit.vignetting = true;
      else
        fail(node.source(), "'fit' may hold \"exposure\", \"white_balance\", \"distortion\" and \"vignetting\"");
    }
  }
  void truth(const toml::node& node, SceneRequest& out) const {
    const toml::table* table = node.as_table();
    if (!table)
      fail(node.source(),
           "'truth' must be a table: {formula = \"...\", tolerance = 0.001, points = [[x, y, value], ...]}");
    Truth& truth = out.truth.emplace();
    for (auto&& [k, value] : *table) {
      const std::string key(k.str());
      if (key == "formula")
        truth.formula = text(value, key);
      else if (key == "tolerance")
        truth.tolerance = number(value, key);
      else if (key == "points")
        truth_points(value, truth);
      else
        fail(value.source(), fmt::format("unknown key '{}' of 'truth'", key));
    }
    if (truth.points.empty()) fail(node.source(), "'truth' needs 'points'");
  }
  void truth_points(const toml::node& node, Truth& out) const {
    const toml::array* array = node.as_array();
    if (!array) fail(node.source(), "'points' must be an array of [x, y, value] or [x, y, red, green, blue]");
    for (const toml::node& item : *array) {
      const std::vector<double> v = numbers(item, "points", 3, 5);
      if (v.size() == 4 || v[0] != std::floor(v[0]) || v[1] != std::floor(v[1]) || v[0] < 0 || v[1] < 0 ||
          v[0] >= kMaxSide || v[1] >= kMaxSide)
        fail(item.source(),
             "a point is [x, y, value] or [x, y, red, green, blue], with x and y whole numbers from the upper left "
             "corner");
      const bool grey = v.size() == 3;
      out.points.push_back(
          {static_cast<int>(v[0]), static_cast<int>(v[1]), {v[2], grey ? v[2] : v[3], grey ? v[2] : v[4]}});
    }
  }

  std::string name_of(const fs::path& scene) const { return scene.lexically_relative(folder_).string(); }

  std::vector<SceneRequest> whole_folder() const {
    std::vector<fs::path> files;
    scenes_below(folder_, files);
    std::vector<SceneRequest> out;
    for (const fs::path& file : files) {
      out.push_back(default_);
      out.back().scene = file, out.back().name = name_of(file);
    }
    return out;
  }

  void one(const toml::table& table, std::vector<SceneRequest>& out) const {
    SceneRequest scene = default_;
    std::string pattern;
    for (auto&& [k, node] : table) {
      const std::string key(k.str());
      if (key == "file")
        pattern = text(node, key);
      else if (key == "name")
        scene.name = text(node, key);
      else if (key == "reference")
        references(node, scene);
      else if (key == "truth")
        truth(node, scene);
      else if (key == "passes")
        passes(node, scene);
      else
        common(key, node, scene);
    }
    if (pattern.empty()) fail(table.source(), "a [[scene]] needs 'file'");
    if (!scene.beside.empty() && !scene.fit.any())
      fail(table.source(), "'beside' is for a photograph: it needs 'crop', 'corners', 'targets' or 'fit'");
    if (scene.fit.any() && !scene.reference)
      fail(table.source(), "'crop', 'corners', 'fit' and 'targets' need a 'reference'");
    if (pattern.find_first_of("*?[") == std::string::npos) {
      scene.scene = (folder_ / pattern).lexically_normal();
      if (!fs::is_regular_file(scene.scene))
        fail(table.source(), fmt::format("there is no scene {}", scene.scene.string()));
      if (scene.name.empty()) scene.name = name_of(scene.scene);
      out.push_back(scene);
      return;
    }
    std::vector<fs::path> files;  // a pattern that says which extension finds scenes of other languages, too
    scenes_below(folder_, files, fs::path(pattern).has_extension());
    const std::size_t before = out.size();
    for (const fs::path& file : files) {
      if (fnmatch(pattern.c_str(), name_of(file).c_str(), 0) != 0) continue;
      out.push_back(scene);
      out.back().scene = file;
      out.back().name = scene.name.empty() ? name_of(file) : scene.name + "/" + file.stem().string();
    }
    if (out.size() == before) fail(table.source(), fmt::format("no scene is named like '{}'", pattern));
  }

  fs::path file_, folder_;
  SceneRequest default_;
};

}  // namespace

std::vector<SceneRequest> read_manifest(const fs::path& file, const SuiteDefaults& defaults) {
  return Manifest(file, defaults).read();
}

}  // namespace verisim::compare
