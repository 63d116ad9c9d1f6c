#include "cli/farm/job.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "compare/json_text.h"
#include "tracer/base/output_file.h"
#include "tracer/base/whole_file.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

using nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr int kMaxTasks = 1'000'000;

ordered_json as_json(const EngineOptions& o) {
  return {{"partition", o.partition}, {"time", o.time},   {"nodes", o.nodes},
          {"cpus", o.cpus},           {"grace", o.grace}, {"extra", o.extra}};
}

EngineOptions engine_options_of(const ordered_json& j) {
  EngineOptions o;
  j.at("partition").get_to(o.partition), j.at("time").get_to(o.time);
  j.at("nodes").get_to(o.nodes), j.at("cpus").get_to(o.cpus), j.at("grace").get_to(o.grace);
  j.at("extra").get_to(o.extra);
  return o;
}

ordered_json as_json(const FarmJob& job) {
  ordered_json json{{"verisim_farm", kFormat},
                    {"job", job.key},
                    {"version", job.version},
                    {"program", job.program},
                    {"engine", job.engine},
                    {"engine_options", as_json(job.engine_options)},
                    {"directory", job.directory.string()},
                    {"scene", job.scene},
                    {"words", job.words},
                    {"tasks", job.tasks}};
  if (job.animation)
    json["animation"] = {{"first", job.first},
                         {"last", job.last},
                         {"step", job.step},
                         {"frames_per_task", job.frames_per_task},
                         {"pictures", {job.before_number.string(), job.digits, job.after_number}}};
  else
    json["still"] = {{"prepass", job.prepass}, {"picture", job.picture.string()}};
  return json;
}

FarmJob job_of(const ordered_json& j) {
  if (const int format = j.at("verisim_farm").get<int>(); format != kFormat)
    throw std::runtime_error(fmt::format("its format is {}, and this verisim reads format {}", format, kFormat));
  FarmJob job;
  j.at("job").get_to(job.key);
  j.at("version").get_to(job.version), j.at("program").get_to(job.program);
  j.at("engine").get_to(job.engine);
  job.engine_options = engine_options_of(j.at("engine_options"));
  job.directory = j.at("directory").get<std::string>();
  j.at("scene").get_to(job.scene), j.at("words").get_to(job.words), j.at("tasks").get_to(job.tasks);
  job.animation = j.contains("animation");
  if (job.animation) {
    const ordered_json& a = j.at("animation");
    a.at("first").get_to(job.first), a.at("last").get_to(job.last), a.at("step").get_to(job.step);
    a.at("frames_per_task").get_to(job.frames_per_task);
    job.before_number = a.at("pictures").at(0).get<std::string>();
    a.at("pictures").at(1).get_to(job.digits), a.at("pictures").at(2).get_to(job.after_number);
  } else {
    j.at("still").at("prepass").get_to(job.prepass);
    job.picture = j.at("still").at("picture").get<std::string>();
  }
  const bool plain_key = !job.key.empty() && std::all_of(job.key.begin(), job.key.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '-' || c == '_';
  });
  if (!plain_key || job.tasks < 1 || job.tasks > kMaxTasks || job.step < 1 || job.frames_per_task < 1 ||
      job.digits < 0 || job.digits > 20)
    throw std::runtime_error("impossible values");
  return job;
}

}  // namespace

std::string Step::name() const {
  return kind == Kind::prepass ? "prepass" : kind == Kind::merge ? "merge" : std::to_string(number);
}

std::vector<Step> FarmJob::steps() const {
  std::vector<Step> all;
  if (prepass) all.push_back({Step::Kind::prepass, 0});
  for (int task = 1; task <= tasks; ++task) all.push_back({Step::Kind::task, task});
  if (!animation) all.push_back({Step::Kind::merge, 0});
  return all;
}

std::vector<int> FarmJob::frames_of(int task) const {
  std::vector<int> frames;
  const long begin = first + static_cast<long>(task - 1) * frames_per_task * step;
  for (int i = 0; i < frames_per_task && begin + static_cast<long>(i) * step <= last; ++i)
    frames.push_back(static_cast<int>(begin + static_cast<long>(i) * step));
  return frames;
}

fs::path FarmJob::picture_of(int frame) const {
  return before_number.string() + fmt::format("{:0{}}", frame, digits) + after_number;
}

void write_manifest(const FarmJob& job) {
  std::string text;
  try {
    text = compare::exact_json_text(as_json(job), 2) + "\n";
  } catch (const ordered_json::exception&) {
    throw std::runtime_error("a job folder keeps names and settings as UTF-8, and one of these is something else");
  }
  write_text_file(job.manifest(), text);
}

FarmJob read_job(const fs::path& folder) {
  FarmJob job;
  const fs::path path = folder / "manifest.json";
  const std::optional<std::string> text = whole_file(path);
  if (!text)
    throw std::runtime_error(fmt::format(
        "'{}' is no job folder of `verisim farm submit`: there is no manifest.json to be read", folder.string()));
  try {
    job = job_of(compare::parse_ordered_json(*text));
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("cannot use '{}': {}", path.string(), error.what()));
  }
  job.folder = fs::canonical(folder);
  return job;
}

}  // namespace verisim::cli
