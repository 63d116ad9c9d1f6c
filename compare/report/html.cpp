#include "compare/report/html.h"

#include <algorithm>
#include <numeric>

#include "compare/json_text.h"
#include "compare/report/display.h"
#include "compare/report/json.h"
#include "compare/report/known_answers.h"
#include "compare/report/page/page.h"
#include "compare/report/scene_pictures.h"
#include "compare/report/verisimilitude.h"
#include "compare/report/why.h"

namespace verisim::compare {
namespace {

using Json = nlohmann::json;

Json scene_data(const SceneResult& s, const Run& run, const ScenePictures& pictures) {
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
  json["why"] = why(s);
  json["known_answer"] = known_answer(s, run);
  json["verisimilitude"] = verisimilitude(s, run);
  if (s.request.reference) json["reference"] = s.request.reference_name();
  json["features"] = s.stochastic_features;
  json["rays"] = s.rays;
  // CPU time where it is known: about 0.6 s of POV-Ray's wall time is sleeping.
  const bool cpu = s.oracle_cpu_seconds > 0 && s.native_cpu_seconds > 0;
  json["cpu"] = cpu;
  json["oracle_seconds"] = cpu ? s.oracle_cpu_seconds : s.oracle_seconds;
  json["native_seconds"] = cpu ? s.native_cpu_seconds : s.native_seconds;
  json["cached"] = s.oracle_cached;
  json["pictures"] = pictures.keys();
  json["same"] = pictures.same();
  if (pictures.fine()) json["fine"] = pictures.fine();
  if (const auto hdr = pictures.exposures()) json["exposures"] = {hdr->start, hdr->stop, hdr->count};
  if (const auto place = pictures.place()) json["place"] = {place->x, place->y, place->width, place->height};
  json["previous"] = s.previous ? Json(to_string(*s.previous)) : Json(nullptr);
  json["previous_rmse"] = s.previous_rmse ? Json(*s.previous_rmse) : Json(nullptr);
  for (const SceneResult::Earlier& earlier : s.history)
    json["history"].push_back({{"started", earlier.started},
                               {"status", to_string(earlier.status)},
                               {"rmse", earlier.rmse ? Json(*earlier.rmse) : Json(nullptr)}});
  json["metrics"] = s.metrics ? to_json(*s.metrics) : Json(nullptr);
  const Json whole = to_json(s);
  if (whole.contains("low_pass")) json["low_pass"] = whole["low_pass"];
  json["suspects"] = whole["suspects"];
  for (const char* part : {"blame", "welch", "truth", "likeness", "layers"})
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

// What failed comes first: its pictures are there before the others are read.
std::vector<std::size_t> worst_first(const std::vector<SceneResult>& scenes) {
  std::vector<std::size_t> order(scenes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return !scenes[i].passed(); });
  return order;
}

// Pictures as base64 text in inert script elements, which the page decodes when it shows them.
void add_pictures(std::string& out, std::size_t scene, const ScenePictures& pictures) {
  for (const std::string& key : pictures.keys()) {
    if (pictures.same() && (key == "n" || key == "tn")) continue;
    out += "<script type=\"text/plain\" id=\"p" + std::to_string(scene) + key + "\">" + base64(pictures.png(key)) +
           "</script>\n";
  }
}

Json run_data(const Run& run, const Json& review) {
  Json data;
  data["started"] = run.started;
  data["oracle_version"] = run.oracle_version;
  data["native_version"] = run.native_version;
  data["cancelled"] = run.cancelled;
  data["known_answers"] = known_answers(run);
  data["names"] = {{"o", run.reference_name}, {"n", run.test_name}};
  if (!review.is_null()) data["review"] = review;
  data["scenes"] = Json::array();
  return data;
}

void append_until(std::string& out, const std::string& text, std::size_t& at, const char* mark) {
  const std::size_t found = text.find(mark, at);
  out.append(text, at, found - at);
  at = found + std::char_traits<char>::length(mark);
}

std::string page(const Json& data, const std::string& pictures, bool served) {
  const std::string page = kReportHtml;
  std::string out;
  out.reserve(page.size() + pictures.size() + 200000);
  std::size_t at = 0;
  append_until(out, page, at, "@POLICY@");
  if (!served) out += kPagePolicy;
  append_until(out, page, at, "@STYLE@");
  out += served ? "<link rel=\"stylesheet\" href=\"report.css\">" : std::string("<style>") + kReportCss + "</style>";
  append_until(out, page, at, "@DATA@");
  out += script_safe(data);
  append_until(out, page, at, "@SCRIPT@");
  // Before the pictures: the table is there while they are still read.
  out += served ? "<script src=\"report.js\"></script>" : std::string("<script>") + kReportJs + "</script>";
  append_until(out, page, at, "@PICTURES@");
  out += pictures;
  return out.append(page, at);
}

}  // namespace

std::string script_safe(const Json& json) {
  const std::string text = json_text(json);
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

std::string HtmlReport::style() { return kReportCss; }
std::string HtmlReport::script() { return kReportJs; }

std::string HtmlReport::file() const {
  Json data = run_data(run_, review_);
  data["scenes"] = std::vector<Json>(run_.scenes.size());
  std::string pictures;
  for (const std::size_t i : worst_first(run_.scenes)) {
    const ScenePictures of_scene(run_.scenes[i]);
    data["scenes"][i] = scene_data(run_.scenes[i], run_, of_scene);
    add_pictures(pictures, i, of_scene);
  }
  return page(data, pictures, false);
}

std::string HtmlReport::served(const Json& review) const {
  if (scenes_.is_null()) {
    scenes_ = Json::array();
    for (const SceneResult& scene : run_.scenes) scenes_.push_back(scene_data(scene, run_, ScenePictures(scene)));
  }
  Json data = run_data(run_, review);
  data["served"] = true, data["scenes"] = scenes_;
  return page(data, "", true);
}

std::string HtmlReport::picture(const std::string& id) const {
  std::size_t number = 0, end = 0;
  try {
    number = std::stoul(id.substr(std::min<std::size_t>(1, id.size())), &end);
  } catch (const std::logic_error&) {
    number = run_.scenes.size();
  }
  if (number >= run_.scenes.size()) throw std::runtime_error("there is no scene of this picture: " + id);
  return ScenePictures(run_.scenes[number]).png(id.substr(1 + end));
}

std::string html_report(const Run& run) { return HtmlReport(run).file(); }

}  // namespace verisim::compare
