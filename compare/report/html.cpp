// The HTML report: one self-contained file. Figures go in as JSON, pictures as base64 text in inert script elements
// that the page decodes when it shows them.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/compare.h"
#include "compare/report/display.h"
#include "compare/report/json.h"
#include "compare/report/page/page.h"

namespace verisim::compare {
namespace {

using Json = nlohmann::json;
constexpr int kThumbnailWidth = 168, kThumbnailHeight = 126;  // twice the size it is shown at

Json scene_data(const SceneResult& s) {
  Json json;
  json["name"] = s.request.name;
  json["file"] = s.request.scene.string();
  json["switches"] = s.request.switches;
  json["tags"] = s.request.tags;
  json["width"] = s.metrics ? s.metrics->width : s.request.width;
  json["height"] = s.metrics ? s.metrics->height : s.request.height;
  json["reduced"] = reduction(json["width"], json["height"]);
  json["class"] = to_string(s.scene_class);
  json["status"] = to_string(s.status);
  json["reason"] = s.reason;
  if (s.request.reference) json["reference"] = s.request.reference_name();
  json["features"] = s.stochastic_features;
  json["rays"] = s.rays;
  // CPU time where it is known: about 0.6 s of POV-Ray's wall time is sleeping.
  const bool cpu = s.oracle_cpu_seconds > 0 && s.native_cpu_seconds > 0;
  json["cpu"] = cpu;
  json["oracle_seconds"] = cpu ? s.oracle_cpu_seconds : s.oracle_seconds;
  json["native_seconds"] = cpu ? s.native_cpu_seconds : s.native_seconds;
  json["cached"] = s.oracle_cached;
  json["previous"] = s.previous ? Json(to_string(*s.previous)) : Json(nullptr);
  json["previous_rmse"] = s.previous_rmse ? Json(*s.previous_rmse) : Json(nullptr);
  json["metrics"] = s.metrics ? to_json(*s.metrics) : Json(nullptr);
  const Json whole = to_json(s);
  if (whole.contains("low_pass")) json["low_pass"] = whole["low_pass"];
  json["suspects"] = whole["suspects"];
  for (const char* part : {"blame", "welch", "truth"})
    if (whole.contains(part)) json[part] = whole[part];
  if (!s.blame_failed.empty()) json["blame_failed"] = s.blame_failed;
  if (s.fit) json["fit"] = s.fit->text();
  if (s.request.truth && s.native_truth) {
    json["formula"] = s.request.truth->formula, json["tolerance"] = s.request.truth->tolerance;
    for (const TruthPoint& point : s.request.truth->points)
      json["points"].push_back({{"x", point.x}, {"y", point.y}, {"value", point.value}});
  }
  for (const PixelTags::Tree& tree : s.trees)
    json["trees"].push_back({{"x", tree.x}, {"y", tree.y}, {"text", tree.text}});
  if (s.metrics) {
    json["histogram"] = s.metrics->histogram;
    json["worst"] = Json::array();
    for (const WorstPixel& p : s.metrics->worst) json["worst"].push_back({p.x, p.y, p.error});
  }
  return json;
}

// In a script element "</script>" and "<!--" would end the text: no '<' is written as itself.
std::string script_safe(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string out;
  out.reserve(text.size());
  for (char c : text) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

void add_png(std::string& out, const std::string& id, const Picture& picture) {
  out += "<script type=\"text/plain\" id=\"" + id + "\">" + base64(png_bytes(picture)) + "</script>\n";
}

// Without alpha: a browser's canvas would lose the colours of transparent pixels.
Picture channels_of(const Picture& picture, bool alpha) {
  Picture out;
  out.width = picture.width, out.height = picture.height, out.channels = alpha ? 1 : 3;
  const int step = picture.channels;
  for (std::size_t i = 0; i < picture.samples.size(); i += step) {
    if (alpha)
      out.samples.push_back(picture.samples[i + step - 1]);
    else
      out.samples.insert(out.samples.end(), picture.samples.begin() + i, picture.samples.begin() + i + 3);
  }
  return out;
}

void add_picture(std::string& out, const std::string& number, char side, const std::filesystem::path& path) {
  if (path.empty()) return;
  try {
    const Picture picture = shown(path);
    if (picture.channels == 4) add_png(out, "p" + number + side + "a", channels_of(picture, true));
    const Picture colors = picture.channels == 4 ? channels_of(picture, false) : picture;
    add_png(out, "p" + number + side, colors);
    if (picture.width > kThumbnailWidth || picture.height > kThumbnailHeight)
      add_png(out, "t" + number + side, thumbnail(colors, kThumbnailWidth, kThumbnailHeight));
  } catch (const std::exception&) {
    // The picture went away: the report says "no picture" in its place.
  }
}

void append_until(std::string& out, const std::string& text, std::size_t& at, const char* mark) {
  const std::size_t found = text.find(mark, at);
  out.append(text, at, found - at);
  at = found + std::char_traits<char>::length(mark);
}

}  // namespace

std::string html_report(const Run& run) {
  Json data;
  data["started"] = run.started;
  data["oracle_version"] = run.oracle_version;
  data["native_version"] = run.native_version;
  data["cancelled"] = run.cancelled;
  data["names"] = {{"o", run.reference_name}, {"n", run.test_name}};
  data["scenes"] = Json::array();
  std::string pictures;
  for (std::size_t i = 0; i < run.scenes.size(); ++i) {
    data["scenes"].push_back(scene_data(run.scenes[i]));
    add_picture(pictures, std::to_string(i), 'o', run.scenes[i].oracle_picture);
    add_picture(pictures, std::to_string(i), 'n', run.scenes[i].native_picture);
  }
  const std::string page = kReportHtml;
  std::string out;
  out.reserve(page.size() + pictures.size() + 200000);
  std::size_t at = 0;
  append_until(out, page, at, "@CSS@");
  out += kReportCss;
  append_until(out, page, at, "@DATA@");
  out += script_safe(data);
  append_until(out, page, at, "@PICTURES@");
  out += pictures;
  append_until(out, page, at, "@JS@");
  out += kReportJs;
  return out.append(page, at);
}

}  // namespace verisim::compare
