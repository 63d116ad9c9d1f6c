// The JSON report, written and read back (trend, "failed last time", runs that go on).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "compare/compare.h"

namespace verisim::compare {

nlohmann::json to_json(const Metrics& metrics);
nlohmann::json to_json(const SceneResult& scene);

// What a report kept of a scene: name, size, class, status, reason, metrics, seconds and rays. Throws
// nlohmann::json::exception on anything else.
SceneResult scene_result_from_json(const nlohmann::json& json);

Summary summarise(const std::vector<SceneResult>& scenes);

}  // namespace verisim::compare
