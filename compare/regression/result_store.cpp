#include "compare/regression/result_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/json_text.h"
#include "compare/oracle/content_hash.h"
#include "compare/report/json.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

// The report keeps the figures, but neither the histogram nor the worst pixels; the pictures are kept in 8 bits only.
Metrics measured_again(const Metrics& kept, Metrics m) {
  m.max_abs = kept.max_abs, m.mae = kept.mae, m.rmse = kept.rmse, m.psnr = kept.psnr, m.bias = kept.bias;
  m.within_1_pct = kept.within_1_pct, m.within_2_pct = kept.within_2_pct;
  m.ssim_mean = kept.ssim_mean, m.ssim_block_min = kept.ssim_block_min, m.flip_mean = kept.flip_mean,
  m.hdr_flip_mean = kept.hdr_flip_mean;
  m.solid_2_pixels = kept.solid_2_pixels, m.solid_4_pixels = kept.solid_4_pixels, m.solid_x = kept.solid_x,
  m.solid_y = kept.solid_y;
  m.drift_max = kept.drift_max, m.drift_x = kept.drift_x, m.drift_y = kept.drift_y;
  m.ciede2000_mean = kept.ciede2000_mean, m.ciede2000_p95 = kept.ciede2000_p95, m.edge_rmse = kept.edge_rmse,
  m.interior_rmse = kept.interior_rmse;
  m.alpha_max_abs = kept.alpha_max_abs, m.alpha_rmse = kept.alpha_rmse, m.nan_pixels = kept.nan_pixels;
  return m;
}

const fs::path& judged(const SceneResult& scene) {
  return scene.judged_picture.empty() ? scene.native_picture : scene.judged_picture;
}

}  // namespace

MetricOptions metric_options(const SceneRequest& request) {
  MetricOptions out;
  out.flip_pixels_per_degree = request.flip_pixels_per_degree;
  out.alpha = request.alpha();
  return out;
}

std::string ResultStore::resume_key(const SceneRequest& r, std::vector<fs::path> files_read) const {
  ContentHash hash;
  hash.add("verisim result 7");
  hash.add(options_.native_version), hash.add(options_.native_identity),
      hash.add(renders_.oracle() ? renders_.oracle()->version_text : "");
  hash.add(fmt::format("{}x{} {} {} {} {} {}", r.width, r.height, options_.replay, options_.runs,
                       options_.baseline.string(), options_.always_blame, static_cast<bool>(options_.tags)));
  for (const std::string& s : r.switches) hash.add(s);
  for (const Pass& pass : r.passes) {
    for (const std::string& s : pass.switches) hash.add(s);
    for (const auto& row : pass.matrix) hash.add(fmt::format("{} {} {}", row[0], row[1], row[2]));
  }
  hash.add(r.scene_class ? to_string(*r.scene_class) : "auto");
  for (const auto& [name, limit] : r.thresholds) hash.add(fmt::format("{} {}", name, limit));
  hash.add(fmt::format("{} {} {} {}", r.allowed.solid_pixels, r.allowed.drift_max.value_or(-1),
                       r.allowed.one_sided_pixels, r.allowed.leaning.value_or(-1)));
  hash.add(fmt::format(
      "{} {} {} {}", r.fit.exposure, r.fit.white_balance,
      r.fit.crop ? fmt::format("{} {} {} {}", r.fit.crop->x, r.fit.crop->y, r.fit.crop->width, r.fit.crop->height) : "",
      r.flip_pixels_per_degree));
  if (r.truth)
    for (const TruthPoint& point : r.truth->points)
      hash.add(fmt::format("{} {} {} {} {} {}", point.x, point.y, point.value[0], point.value[1], point.value[2],
                           r.truth->tolerance));
  files_read.push_back(r.scene);
  if (const fs::path stored = renders_.stored_picture(r); !stored.empty()) files_read.push_back(stored);
  for (const fs::path& other : renders_.alternatives(r)) files_read.push_back(other);
  if (!r.ignored.mask.empty()) files_read.push_back(r.ignored.mask);
  for (const Crop& c : r.ignored.rectangles) hash.add(fmt::format("{} {} {} {}", c.x, c.y, c.width, c.height));
  for (const std::string& object : r.ignored.objects) hash.add(object);
  for (const auto& limits : {r.pixel_limits, r.warnings.pixels})
    hash.add(limits ? fmt::format("{} {} {}", limits->absolute, limits->relative, limits->pixels) : "");
  for (const auto& [name, limit] : r.warnings.figures) hash.add(fmt::format("{} {}", name, limit));
  hash.add(options_.reference_identity);
  for (const LayerRule& rule : r.layers) hash.add(rule.text);
  for (const std::string& renderer : r.beside) hash.add(renderer);
  hash.add(fmt::format("{} {}", r.fit.distortion, r.fit.vignetting));
  if (r.fit.corners)
    for (const ImagePoint& p : *r.fit.corners) hash.add(fmt::format("{} {}", p.x, p.y));
  for (const ColorTarget& t : r.fit.targets)
    hash.add(fmt::format("{} {} {} {} {} {} {}", t.x, t.y, t.width, t.height, t.srgb[0], t.srgb[1], t.srgb[2]));
  std::sort(files_read.begin(), files_read.end());
  for (const fs::path& file : files_read) hash.add(file.string()), hash.add_file(file);
  return hash.hex();
}

bool ResultStore::resumed(const std::string& stem, SceneResult& result) const {
  std::ifstream in(renders_.work() / (stem + ".result.json"));
  if (!in) return false;
  const auto json = parse_json(in);
  if (!json.is_object()) return false;
  try {
    std::vector<fs::path> files;
    for (const std::string& file : json.at("files_read").get<std::vector<std::string>>()) files.emplace_back(file);
    if (json.at("key") != resume_key(result.request, files)) return false;
    SceneResult read = scene_result_from_json(json.at("result"));
    read.request = result.request;
    for (auto [path, name] :
         {std::pair(&read.oracle_picture, "oracle_picture"), std::pair(&read.native_picture, "native_picture"),
          std::pair(&read.judged_picture, "judged_picture"), std::pair(&read.p_map, "p_map")})
      if (const std::string file = json.value(name, ""); !file.empty()) *path = renders_.work() / file;
    for (const auto& tree : json.value("trees", nlohmann::json::array()))
      read.trees.push_back({tree.at("x"), tree.at("y"), tree.at("text")});
    if (!read.oracle_picture.empty() && !read.native_picture.empty() && read.metrics)
      read.metrics =
          measured_again(*read.metrics, measure(image::read_picture(read.oracle_picture),
                                                image::read_picture(judged(read)), metric_options(result.request)));
    result = std::move(read);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

void ResultStore::remember(const std::string& stem, const std::vector<fs::path>& files_read,
                           const SceneResult& result) const {
  nlohmann::json json;
  json["key"] = resume_key(result.request, files_read);
  json["files_read"] = nlohmann::json::array();
  for (const fs::path& file : files_read) json["files_read"].push_back(file.string());
  for (const PixelTags::Tree& tree : result.trees)
    json["trees"].push_back({{"x", tree.x}, {"y", tree.y}, {"text", tree.text}});
  json["result"] = to_json(result);
  json["oracle_picture"] = result.oracle_picture.filename().string();
  json["native_picture"] = result.native_picture.filename().string();
  json["judged_picture"] = result.judged_picture.filename().string();
  json["p_map"] = result.p_map.filename().string();
  write_report(json_text(json, 1), renders_.work() / (stem + ".result.json"));
}

}  // namespace verisim::compare
