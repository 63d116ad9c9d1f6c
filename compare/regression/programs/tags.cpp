// What pixels show, asked from a verisim program as a process of its own; and its JSON form.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/compare.h"
#include "compare/json_text.h"
#include "compare/oracle/process.h"
#include "compare/oracle/working_copy.h"
#include "compare/regression/programs/program_call.h"
#include "tracer/base/whole_file.h"

namespace verisim::compare {
namespace {
constexpr double kLightUnit = 1e-6;  // of linear light, 1 is white

// Numbers of five digits: more would not be seen, and take more of the file.
nlohmann::json short_numbers(const std::vector<float>& values) {
  nlohmann::json out = nlohmann::json::array();
  for (float v : values) {
    const double unit = v == 0 || !std::isfinite(v) ? 1 : std::pow(10, std::floor(std::log10(std::fabs(v))) - 4);
    out.push_back(std::isfinite(v) ? std::round(v / unit) * unit : 0);
  }
  return out;
}
}  // namespace

std::string tags_json(const PixelTags& tags) {
  nlohmann::json json;
  json["width"] = tags.width, json["height"] = tags.height, json["step"] = tags.step;
  json["tags"] = nlohmann::json::array();
  for (const PixelTags::Tag& tag : tags.tags) json["tags"].push_back({{"kind", tag.kind}, {"name", tag.name}});
  json["sets"] = tags.sets;
  json["pixels"] = tags.set_of;
  json["trees"] = nlohmann::json::array();
  for (const PixelTags::Tree& tree : tags.trees)
    json["trees"].push_back({{"x", tree.x}, {"y", tree.y}, {"text", tree.text}});
  // Whole numbers are short: a unit is far below what 16 bits hold.
  json["parts"] = nlohmann::json::array();
  for (const PixelTags::Part& part : tags.parts) {
    nlohmann::json& out = json["parts"].emplace_back(nlohmann::json{{"kind", part.kind}, {"name", part.name}});
    nlohmann::json& light = out["light"] = nlohmann::json::array();
    for (float v : part.light)
      light.push_back(std::isfinite(v) ? std::llround(std::clamp<double>(v, -1e6, 1e6) / kLightUnit) : 0);
  }
  json["surfaces"] = {{"point", short_numbers(tags.surfaces.point)},
                      {"normal", short_numbers(tags.surfaces.normal)},
                      {"diffuse", short_numbers(tags.surfaces.diffuse)}};
  return json_text(json) + "\n";  // file names may hold any bytes
}

PixelTags tags_from_json(const std::string& text) {
  const auto json = parse_json(text);
  PixelTags out;
  try {
    out.width = json.at("width"), out.height = json.at("height"), out.step = json.at("step");
    for (const auto& tag : json.at("tags")) out.tags.push_back({tag.at("kind"), tag.at("name")});
    out.sets = json.at("sets").get<std::vector<std::vector<int>>>();
    out.set_of = json.at("pixels").get<std::vector<int>>();
    for (const auto& part : json.value("parts", nlohmann::json::array())) {
      PixelTags::Part& in = out.parts.emplace_back();
      in.kind = part.at("kind"), in.name = part.at("name");
      for (const auto& v : part.at("light")) in.light.push_back(static_cast<float>(v.get<double>() * kLightUnit));
    }
    if (const auto surfaces = json.find("surfaces"); surfaces != json.end()) {
      out.surfaces.point = surfaces->at("point").get<std::vector<float>>();
      out.surfaces.normal = surfaces->at("normal").get<std::vector<float>>();
      out.surfaces.diffuse = surfaces->at("diffuse").get<std::vector<float>>();
    }
    for (const auto& tree : json.at("trees")) out.trees.push_back({tree.at("x"), tree.at("y"), tree.at("text")});
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(fmt::format("not a list of pixel tags: {}", error.what()));
  }
  return out;
}

TagSource tags_of_program(const std::filesystem::path& program) {
  return [program](const NativeRequest& request, int step, const std::vector<std::pair<int, int>>& trees) {
    const TemporaryFolder scratch;
    const std::filesystem::path file = scratch.path() / "tags.json";
    ProcessRequest process = program_call(program, "explain", request);
    process.arguments.insert(process.arguments.end(), {"--tags", file.string(), "--tags-step", std::to_string(step)});
    for (const auto& [x, y] : trees)
      process.arguments.insert(process.arguments.end(), {"--tree", fmt::format("{},{}", x, y)});
    const ProcessResult run = run_process(process);
    const std::optional<std::string> tags = run.succeeded() ? whole_file(file) : std::nullopt;
    if (!tags)
      throw std::runtime_error(
          fmt::format("the pixels could not be explained: {}", run.how_it_ended(request.time_limit)));
    return tags_from_json(*tags);
  };
}

}  // namespace verisim::compare
