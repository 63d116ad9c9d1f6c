#include "cli/farm/log_file.h"

#include <algorithm>
#include <chrono>
#include <fstream>

#include <nlohmann/json.hpp>

#include "compare/json_text.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

using Json = nlohmann::json;

// What begins like a line of JSON and is none was broken off, or is a scene's.
Json parsed(const std::string& line) {
  if (!line.starts_with("{\"event\":")) return {};
  Json value = compare::parse_json(line);
  return value.is_object() ? value : Json();
}

template <class T>
std::optional<T> value_of(const Json& line, const char* key) {
  const auto found = line.find(key);
  if (found == line.end() || found->is_null()) return std::nullopt;
  try {
    return found->get<T>();
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

void take(StepLog& log, const std::string& line) {
  const Json said = parsed(line);
  const std::string event = value_of<std::string>(said, "event").value_or("");
  if (event.empty()) {
    if (line.find("error:") != std::string::npos || line.starts_with("verisim merge: ")) log.message = line;
    return;
  }
  log.begun = true;
  if (event == "start") {
    log.node = value_of<std::string>(said, "node").value_or("");
    log.exit_status.reset(), log.requeued = false;
    log.message.clear(), log.remaining.reset();
  } else if (event == "progress") {
    log.stage = value_of<std::string>(said, "stage").value_or("");
    log.fraction = value_of<double>(said, "overall").value_or(0);
    log.remaining = value_of<double>(said, "remaining");
  } else if (event == "end") {
    if (const auto message = value_of<std::string>(said, "message")) log.message = *message;
  } else if (event == "requeue") {
    log.requeued = true;
  } else if (event == "exit") {
    log.exit_status = value_of<int>(said, "status");
  }
}

}  // namespace

StepLog read_log(const fs::path& path) {
  constexpr std::streamoff kTail = 16384;
  StepLog log;
  std::ifstream stream(path, std::ios::binary);
  std::string line;
  if (!std::getline(stream, line)) return log;
  log.begin = value_of<std::int64_t>(parsed(line), "time");
  take(log, line);
  stream.seekg(0, std::ios::end);
  const std::streamoff size = stream.tellg();
  stream.seekg(std::max<std::streamoff>(size - kTail, 0));
  if (size > kTail) std::getline(stream, line);  // the end of a line
  while (std::getline(stream, line)) take(log, line);
  std::error_code error;
  const auto written = fs::last_write_time(path, error);
  if (!error) log.age = std::chrono::duration<double>(fs::file_time_type::clock::now() - written).count();
  return log;
}

}  // namespace verisim::cli
