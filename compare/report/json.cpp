#include "compare/report/json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/json_text.h"

namespace verisim::compare {
namespace {

using OrderedJson = nlohmann::ordered_json;

// JSON has no infinity; nothing that is measured comes near.

template <typename J>
void put(J& json, const char* key, const std::optional<double>& value) {
  if (value) json[key] = *value;
}

template <typename J>
J metrics_as(const Metrics& m) {
  J json;
  json["max_abs"] = m.max_abs;
  json["mae"] = m.mae;
  json["rmse"] = m.rmse;
  json["psnr"] = m.psnr;
  json["within_1_pct"] = m.within_1_pct;
  json["within_2_pct"] = m.within_2_pct;
  json["bias"] = m.bias;
  json["ssim_mean"] = m.ssim_mean;
  json["ssim_block_min"] = m.ssim_block_min;
  json["solid_2_pixels"] = m.solid_2_pixels, json["solid_4_pixels"] = m.solid_4_pixels,
  json["solid_at"] = {m.solid_x, m.solid_y};
  json["one_sided_pixels"] = m.one_sided_pixels, json["one_sided_at"] = {m.one_sided_x, m.one_sided_y};
  json["leaning"] = m.signs.share(), json["brighter_pixels"] = m.signs.brighter, json["darker_pixels"] = m.signs.darker;
  json["drift_max"] = m.drift_max, json["drift_at"] = {m.drift_x, m.drift_y};
  json["flip_mean"] = m.flip_mean;
  put(json, "hdr_flip_mean", m.hdr_flip_mean);
  json["ciede2000_mean"] = m.ciede2000_mean;
  json["ciede2000_p95"] = m.ciede2000_p95;
  put(json, "edge_rmse", m.edge_rmse);
  put(json, "interior_rmse", m.interior_rmse);
  put(json, "alpha_max_abs", m.alpha_max_abs);
  put(json, "alpha_rmse", m.alpha_rmse);
  json["nan_pixels"] = m.nan_pixels;
  return json;
}

template <typename J>
J low_pass_as(const LowPass& l) {
  J json;
  json["mad"] = l.mad, json["bias"] = l.bias, json["rmse"] = l.rmse;
  return json;
}

template <typename J>
J blame_as(const Blame& b) {
  J json;
  json["bad_pixels"] = b.bad, json["good_pixels"] = b.good, json["limit"] = b.limit;
  json["objects"] = J::array();
  for (const ObjectError& o : b.objects) {
    J object;
    object["name"] = o.name, object["pixels_pct"] = o.pixels_pct, object["bad_pct"] = o.bad_pct,
    object["rmse"] = o.rmse, object["bias"] = o.bias, object["max_abs"] = o.max_abs;
    object["share"] = o.share, object["worst"] = {o.worst_x, o.worst_y};
    json["objects"].push_back(object);
  }
  json["common"] = J::array();
  for (const CommonTag& c : b.common) {
    J tag;
    tag["kind"] = c.kind, tag["name"] = c.name, tag["bad_pct"] = c.bad_pct, tag["good_pct"] = c.good_pct,
    tag["correlation"] = c.correlation;
    json["common"].push_back(tag);
  }
  return json;
}

Blame blame_from(const nlohmann::json& json) {
  Blame b;
  b.bad = json.at("bad_pixels"), b.good = json.at("good_pixels"), b.limit = json.at("limit");
  for (const auto& o : json.at("objects"))
    b.objects.push_back({o.at("name"), o.at("pixels_pct"), o.at("bad_pct"), o.at("rmse"), o.at("bias"), o.at("max_abs"),
                         o.at("share"), o.at("worst").at(0), o.at("worst").at(1)});
  for (const auto& c : json.at("common"))
    b.common.push_back({c.at("kind"), c.at("name"), c.at("bad_pct"), c.at("good_pct"), c.at("correlation")});
  return b;
}

template <typename J>
J truth_as(const TruthError& t) {
  J json;
  json["max"] = t.max, json["rms"] = t.rms, json["worst"] = {t.worst_x, t.worst_y}, json["values"] = t.values;
  return json;
}
TruthError truth_from(const nlohmann::json& json) {
  return {json.at("max"), json.at("rms"), json.at("worst").at(0), json.at("worst").at(1),
          json.at("values").get<std::vector<std::array<double, 3>>>()};
}

template <typename J>
J scene_as(const SceneResult& s) {
  J json;
  json["scene"] = s.request.name;
  json["width"] = s.request.width;
  json["height"] = s.request.height;
  json["class"] = to_string(s.scene_class);
  json["status"] = to_string(s.status);
  json["reason"] = s.reason;
  json["metrics"] = s.metrics ? metrics_as<J>(*s.metrics) : J(nullptr);
  json["seconds"]["oracle"] = s.oracle_seconds;
  json["seconds"]["native"] = s.native_seconds;
  json["cpu_seconds"]["oracle"] = s.oracle_cpu_seconds;
  json["cpu_seconds"]["native"] = s.native_cpu_seconds;
  json["rays"] = J::object();
  for (const auto& [kind, count] : s.rays) json["rays"][kind] = count;
  json["tags"] = s.request.tags;
  if (!s.request.known_failure.empty()) json["known_failure"] = s.request.known_failure;
  json["stochastic_features"] = s.stochastic_features;
  json["suspects"] = J::array();
  for (const Suspicion& v : s.suspicions) {
    J suspect;
    suspect["what"] = v.what, suspect["detail"] = v.detail, suspect["explained"] = v.explained;
    suspect["precision"] = v.precision, suspect["sure"] = v.sure;
    if (!v.pixels.empty()) suspect["pixels"] = v.pixels;
    json["suspects"].push_back(suspect);
  }
  if (s.native_low_pass) json["low_pass"]["native"] = low_pass_as<J>(*s.native_low_pass);
  if (s.noise_low_pass) json["low_pass"]["noise"] = low_pass_as<J>(*s.noise_low_pass);
  if (s.welch) {
    J& welch = json["welch"];
    welch["rejected"] = s.welch->rejected, welch["pixel_p"] = s.welch->pixel_p,
    welch["worst"] = {s.welch->worst_x, s.welch->worst_y};
    welch["mean_p"] = s.welch->mean_p, welch["mean_difference"] = s.welch->mean_difference;
  }
  if (s.blame) json["blame"] = blame_as<J>(*s.blame);
  if (!s.blame_failed.empty()) json["blame_failed"] = s.blame_failed;
  if (s.fit) {
    J& fit = json["fit"];
    fit["text"] = s.fit->text(), fit["stops"] = s.fit->stops, fit["white_balance"] = s.fit->balance,
    fit["resampled"] = s.fit->resampled;
    fit["reference_size"] = {s.fit->reference_width, s.fit->reference_height};
    if (const auto& a = s.fit->alignment) {
      for (std::size_t i = 0; i < 4; ++i) {
        fit["corners"].push_back({a->corners[i].x, a->corners[i].y});
        fit["corner_errors"].push_back({a->corner_errors[i].x, a->corner_errors[i].y});
      }
      fit["distortion"] = {a->distortion, a->distortion_error};
    }
    if (const auto& v = s.fit->vignetting) fit["vignetting"] = {v->a, v->b, v->a_error, v->b_error};
    if (const auto& t = s.fit->targets)
      fit["targets"] = {{"matrix", t->matrix}, {"whole_matrix", t->whole_matrix}, {"ciede2000", t->errors}};
    fit["stops_error"] = s.fit->stops_error, fit["noise"] = s.fit->noise;
    if (s.fit->crop) fit["crop"] = {s.fit->crop->x, s.fit->crop->y, s.fit->crop->width, s.fit->crop->height};
  }
  for (const LayerResult& l : s.layers)
    json["layers"].push_back({{"name", l.name},
                              {"kind", l.kind},
                              {"status", to_string(l.status)},
                              {"reason", l.reason},
                              {"max_abs", std::isfinite(l.max_abs) ? J(l.max_abs) : J(nullptr)},
                              {"wrong_pixels", l.wrong},
                              {"worst", {l.worst_x, l.worst_y}}});
  for (const Likeness& l : s.verisimilitude) {
    J likeness;
    likeness["renderer"] = l.renderer;
    if (l.failed.empty())
      likeness["ciede2000_mean"] = l.ciede2000_mean, likeness["flip_mean"] = l.flip_mean, likeness["rmse"] = l.rmse;
    else
      likeness["failed"] = l.failed;
    json["likeness"].push_back(likeness);
  }
  if (s.oracle_truth) json["truth"]["oracle"] = truth_as<J>(*s.oracle_truth);
  if (s.native_truth) json["truth"]["native"] = truth_as<J>(*s.native_truth);
  return json;
}

template <typename J>
J summary_as(const Summary& s) {
  J json;
  json["scenes"] = s.scenes;
  for (Status status : kStatuses) {
    const auto it = s.count.find(status);
    json[to_string(status)] = it == s.count.end() ? 0 : it->second;
  }
  json["known_failures"] = s.known_failures;
  json["seconds"]["oracle"] = s.oracle_seconds;
  json["seconds"]["native"] = s.native_seconds;
  json["cpu_seconds"]["oracle"] = s.oracle_cpu_seconds;
  json["cpu_seconds"]["native"] = s.native_cpu_seconds;
  return json;
}

LowPass low_pass_from(const nlohmann::json& json) { return {json.at("mad"), json.at("bias"), json.at("rmse")}; }

}  // namespace

nlohmann::json to_json(const Metrics& metrics) { return metrics_as<nlohmann::json>(metrics); }
nlohmann::json to_json(const SceneResult& scene) { return scene_as<nlohmann::json>(scene); }

namespace {

Metrics metrics_from(const nlohmann::json& m, int width, int height) {
  Metrics out;
  out.width = width, out.height = height;
  out.max_abs = m.at("max_abs"), out.mae = m.at("mae"), out.rmse = m.at("rmse"), out.psnr = m.at("psnr");
  out.within_1_pct = m.at("within_1_pct"), out.within_2_pct = m.at("within_2_pct"), out.bias = m.at("bias");
  out.ssim_mean = m.at("ssim_mean"), out.ssim_block_min = m.at("ssim_block_min"), out.flip_mean = m.at("flip_mean");
  out.ciede2000_mean = m.value("ciede2000_mean", 0.0), out.ciede2000_p95 = m.value("ciede2000_p95", 0.0),
  out.nan_pixels = m.value("nan_pixels", std::uint64_t{0});
  out.solid_2_pixels = m.value("solid_2_pixels", std::uint64_t{0}),
  out.solid_4_pixels = m.value("solid_4_pixels", std::uint64_t{0}), out.drift_max = m.value("drift_max", 0.0);
  out.signs = {static_cast<std::uint64_t>(out.width) * static_cast<std::uint64_t>(out.height),
               m.value("brighter_pixels", std::uint64_t{0}), m.value("darker_pixels", std::uint64_t{0})};
  out.one_sided_pixels = m.value("one_sided_pixels", std::uint64_t{0});
  if (m.contains("one_sided_at")) out.one_sided_x = m["one_sided_at"].at(0), out.one_sided_y = m["one_sided_at"].at(1);
  if (m.contains("solid_at")) out.solid_x = m["solid_at"].at(0), out.solid_y = m["solid_at"].at(1);
  if (m.contains("drift_at")) out.drift_x = m["drift_at"].at(0), out.drift_y = m["drift_at"].at(1);
  for (auto [name, value] : {std::pair("hdr_flip_mean", &out.hdr_flip_mean), std::pair("edge_rmse", &out.edge_rmse),
                             std::pair("interior_rmse", &out.interior_rmse),
                             std::pair("alpha_max_abs", &out.alpha_max_abs), std::pair("alpha_rmse", &out.alpha_rmse)})
    if (m.contains(name)) *value = m[name].get<double>();
  return out;
}

Fit fit_from(const nlohmann::json& f) {
  Fit fit;
  fit.stops = f.at("stops"), fit.balance = f.at("white_balance").get<std::array<double, 3>>(),
  fit.resampled = f.at("resampled");
  fit.reference_width = f.at("reference_size").at(0), fit.reference_height = f.at("reference_size").at(1);
  fit.stops_error = f.value("stops_error", 0.0), fit.noise = f.value("noise", 0.0);
  if (f.contains("corners")) {
    Alignment& a = fit.alignment.emplace();
    for (std::size_t i = 0; i < 4; ++i) {
      a.corners[i] = {f["corners"].at(i).at(0), f["corners"].at(i).at(1)};
      a.corner_errors[i] = {f["corner_errors"].at(i).at(0), f["corner_errors"].at(i).at(1)};
    }
    a.distortion = f["distortion"].at(0), a.distortion_error = f["distortion"].at(1);
  }
  if (f.contains("vignetting")) {
    const auto& v = f["vignetting"];
    fit.vignetting = Vignetting{v.at(0), v.at(1), v.at(2), v.at(3)};
  }
  if (f.contains("targets")) {
    const auto& t = f["targets"];
    fit.targets = TargetFit{t.at("matrix").get<std::array<double, 9>>(), t.at("whole_matrix"),
                            t.at("ciede2000").get<std::vector<double>>()};
  }
  if (f.contains("crop")) fit.crop = Crop{f["crop"].at(0), f["crop"].at(1), f["crop"].at(2), f["crop"].at(3)};
  return fit;
}

}  // namespace

SceneResult scene_result_from_json(const nlohmann::json& json) {
  SceneResult s;
  s.request.name = json.at("scene");
  s.request.width = json.at("width"), s.request.height = json.at("height");
  s.scene_class = json.at("class") == "stochastic" ? SceneClass::stochastic : SceneClass::deterministic;
  s.status = status_from_string(json.at("status")).value_or(Status::error);
  s.reason = json.value("reason", "");
  s.oracle_seconds = json.at("seconds").at("oracle"), s.native_seconds = json.at("seconds").at("native");
  if (json.contains("cpu_seconds"))
    s.oracle_cpu_seconds = json["cpu_seconds"].at("oracle"), s.native_cpu_seconds = json["cpu_seconds"].at("native");
  s.rays = json.value("rays", std::map<std::string, std::uint64_t>());
  s.stochastic_features = json.value("stochastic_features", std::vector<std::string>());
  for (const auto& suspect : json.value("suspects", nlohmann::json::array()))
    s.suspicions.push_back({suspect.at("what"), suspect.at("detail"), suspect.at("explained"),
                            suspect.value("precision", 1.0), suspect.value("sure", 0.0),
                            suspect.value("pixels", PixelRuns())});
  if (const auto& m = json.at("metrics"); m.is_object()) s.metrics = metrics_from(m, s.request.width, s.request.height);
  if (json.contains("low_pass")) {
    if (json["low_pass"].contains("native")) s.native_low_pass = low_pass_from(json["low_pass"]["native"]);
    if (json["low_pass"].contains("noise")) s.noise_low_pass = low_pass_from(json["low_pass"]["noise"]);
  }
  if (json.contains("welch")) {
    const auto& w = json["welch"];
    s.welch = {w.at("rejected"),    w.at("pixel_p"), w.at("worst").at(0),
               w.at("worst").at(1), w.at("mean_p"),  w.at("mean_difference")};
  }
  if (json.contains("blame")) s.blame = blame_from(json["blame"]);
  s.blame_failed = json.value("blame_failed", "");
  if (json.contains("fit")) s.fit = fit_from(json["fit"]);
  for (const auto& l : json.value("layers", nlohmann::json::array()))
    s.layers.push_back({l.at("name"), l.at("kind"), status_from_string(l.at("status")).value_or(Status::differ),
                        l.at("reason"), l.at("max_abs").is_number() ? l.at("max_abs").get<double>() : HUGE_VAL,
                        l.at("wrong_pixels"), l.at("worst").at(0), l.at("worst").at(1)});
  for (const auto& l : json.value("likeness", nlohmann::json::array()))
    s.verisimilitude.push_back({l.at("renderer"), l.value("ciede2000_mean", 0.0), l.value("flip_mean", 0.0),
                                l.value("rmse", 0.0), l.value("failed", "")});
  if (json.contains("truth")) {
    if (json["truth"].contains("oracle")) s.oracle_truth = truth_from(json["truth"]["oracle"]);
    if (json["truth"].contains("native")) s.native_truth = truth_from(json["truth"]["native"]);
  }
  return s;
}

Summary summarise(const std::vector<SceneResult>& scenes) {
  Summary out;
  for (const SceneResult& s : scenes) {
    ++out.scenes, ++out.count[s.status], out.known_failures += !s.passed() && !s.failed();
    out.oracle_seconds += s.oracle_seconds, out.native_seconds += s.native_seconds;
    out.oracle_cpu_seconds += s.oracle_cpu_seconds, out.native_cpu_seconds += s.native_cpu_seconds;
  }
  return out;
}

bool Summary::failed() const {
  int bad = 0;
  for (const auto& [status, number] : count) bad += status != Status::exact && status != Status::match ? number : 0;
  return bad > known_failures;
}

std::string metrics_json(const Metrics& metrics) { return json_text(metrics_as<OrderedJson>(metrics), 2) + "\n"; }

std::string json_report(const Run& run) {
  OrderedJson json;
  json["scenes"] = OrderedJson::array();
  for (const SceneResult& scene : run.scenes) json["scenes"].push_back(scene_as<OrderedJson>(scene));
  json["summary"] = summary_as<OrderedJson>(run.summary);
  json["reference"] = run.reference_name;
  json["oracle_version"] = run.oracle_version;
  json["native_version"] = run.native_version;
  json["started"] = run.started;
  json["cancelled"] = run.cancelled;
  // Scene names and messages may hold any bytes.
  return json_text(json, 2) + "\n";
}

}  // namespace verisim::compare
