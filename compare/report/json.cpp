#include "compare/report/json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace verisim::compare {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity; nothing that is measured comes near.
constexpr double kInfinitePsnr = 999;

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
  json["psnr"] = std::isfinite(m.psnr) ? m.psnr : kInfinitePsnr;
  json["within_1_pct"] = m.within_1_pct;
  json["within_2_pct"] = m.within_2_pct;
  json["bias"] = m.bias;
  json["ssim_mean"] = m.ssim_mean;
  json["ssim_block_min"] = m.ssim_block_min;
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
  json["stochastic_features"] = s.stochastic_features;
  json["suspects"] = J::array();
  for (const Suspicion& v : s.suspicions) {
    J suspect;
    suspect["what"] = v.what, suspect["detail"] = v.detail, suspect["explained"] = v.explained;
    json["suspects"].push_back(suspect);
  }
  if (s.native_low_pass) json["low_pass"]["native"] = low_pass_as<J>(*s.native_low_pass);
  if (s.noise_low_pass) json["low_pass"]["noise"] = low_pass_as<J>(*s.noise_low_pass);
  return json;
}

template <typename J>
J summary_as(const Summary& s) {
  J json;
  json["scenes"] = s.scenes;
  for (Status status : {Status::exact, Status::match, Status::differ, Status::unsupported, Status::error, Status::oracle_failed}) {
    const auto it = s.count.find(status);
    json[to_string(status)] = it == s.count.end() ? 0 : it->second;
  }
  json["seconds"]["oracle"] = s.oracle_seconds;
  json["seconds"]["native"] = s.native_seconds;
  return json;
}

LowPass low_pass_from(const nlohmann::json& json) { return {json.at("mad"), json.at("bias"), json.at("rmse")}; }

}  // namespace

nlohmann::json to_json(const Metrics& metrics) { return metrics_as<nlohmann::json>(metrics); }
nlohmann::json to_json(const SceneResult& scene) { return scene_as<nlohmann::json>(scene); }
nlohmann::json to_json(const Summary& summary) { return summary_as<nlohmann::json>(summary); }

SceneResult scene_result_from_json(const nlohmann::json& json) {
  SceneResult s;
  s.request.name = json.at("scene");
  s.request.width = json.at("width"), s.request.height = json.at("height");
  s.scene_class = json.at("class") == "stochastic" ? SceneClass::stochastic : SceneClass::deterministic;
  s.status = status_from_string(json.at("status")).value_or(Status::error);
  s.reason = json.value("reason", "");
  s.oracle_seconds = json.at("seconds").at("oracle"), s.native_seconds = json.at("seconds").at("native");
  if (json.contains("cpu_seconds")) s.oracle_cpu_seconds = json["cpu_seconds"].at("oracle"), s.native_cpu_seconds = json["cpu_seconds"].at("native");
  s.rays = json.value("rays", std::map<std::string, std::uint64_t>());
  s.stochastic_features = json.value("stochastic_features", std::vector<std::string>());
  for (const auto& suspect : json.value("suspects", nlohmann::json::array())) s.suspicions.push_back({suspect.at("what"), suspect.at("detail"), suspect.at("explained")});
  if (const auto& m = json.at("metrics"); m.is_object()) {
    Metrics& out = s.metrics.emplace();
    out.width = s.request.width, out.height = s.request.height;
    out.max_abs = m.at("max_abs"), out.mae = m.at("mae"), out.rmse = m.at("rmse"), out.psnr = m.at("psnr");
    out.within_1_pct = m.at("within_1_pct"), out.within_2_pct = m.at("within_2_pct"), out.bias = m.at("bias");
    out.ssim_mean = m.at("ssim_mean"), out.ssim_block_min = m.at("ssim_block_min"), out.flip_mean = m.at("flip_mean");
  }
  if (json.contains("low_pass")) {
    if (json["low_pass"].contains("native")) s.native_low_pass = low_pass_from(json["low_pass"]["native"]);
    if (json["low_pass"].contains("noise")) s.noise_low_pass = low_pass_from(json["low_pass"]["noise"]);
  }
  return s;
}

Summary summarise(const std::vector<SceneResult>& scenes) {
  Summary out;
  for (const SceneResult& s : scenes) {
    ++out.scenes, ++out.count[s.status];
    out.oracle_seconds += s.oracle_seconds, out.native_seconds += s.native_seconds;
  }
  return out;
}

bool Summary::failed() const {
  return std::any_of(count.begin(), count.end(), [](const auto& entry) { return entry.second > 0 && entry.first != Status::exact && entry.first != Status::match; });
}

std::string metrics_json(const Metrics& metrics) { return metrics_as<Json>(metrics).dump(2) + "\n"; }

std::string json_report(const Run& run) {
  Json json;
  json["scenes"] = Json::array();
  for (const SceneResult& scene : run.scenes) json["scenes"].push_back(scene_as<Json>(scene));
  json["summary"] = summary_as<Json>(run.summary);
  json["oracle_version"] = run.oracle_version;
  json["native_version"] = run.native_version;
  json["started"] = run.started;
  json["cancelled"] = run.cancelled;
  // Scene names and messages may hold any bytes.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace verisim::compare
