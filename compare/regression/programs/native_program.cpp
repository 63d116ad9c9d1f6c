// A renderer as a process of its own: its crash or hang costs one scene.
#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compare/compare.h"
#include "compare/json_text.h"
#include "compare/oracle/povray.h"
#include "compare/oracle/process.h"
#include "compare/oracle/working_copy.h"
#include "compare/regression/programs/program_call.h"

extern char** environ;

namespace verisim::compare {
namespace {

std::vector<std::pair<std::string, std::string>> current_environment() {
  std::vector<std::pair<std::string, std::string>> out;
  for (char** entry = environ; *entry; ++entry)
    if (const std::string text = *entry; text.find('=') != std::string::npos)
      out.emplace_back(text.substr(0, text.find('=')), text.substr(text.find('=') + 1));
  return out;
}

std::string message_of(const std::string& err) {
  std::istringstream in(err);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (const auto cr = line.find_last_of('\r'); cr != std::string::npos && cr + 1 < line.size()) line.erase(0, cr + 1);
    if (line.find("error:") != std::string::npos || line.find("unsupported:") != std::string::npos) return line;
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  return last;
}

void read_statistics(const std::filesystem::path& file, NativeResult& out) {
  std::ifstream in(file);
  if (!in) return;
  const auto json = parse_json(in);
  if (!json.is_object()) return;
  try {
    out.rays = json.value("rays", out.rays);
    out.stochastic_features = json.value("stochastic_features", out.stochastic_features);
    for (const std::string& path : json.value("files_read", std::vector<std::string>()))
      out.files_read.emplace_back(path);
  } catch (const nlohmann::json::exception&) {
    // Statistics of another shape: the picture is compared all the same.
  }
}

}  // namespace

ProcessRequest program_call(const std::filesystem::path& program, const std::string& command,
                            const NativeRequest& request) {
  ProcessRequest process;
  process.arguments = {program.string(), command, request.scene.string(), fmt::format("+W{}", request.width),
                       fmt::format("+H{}", request.height)};
  auto& arguments = process.arguments;
  arguments.insert(arguments.end(), request.switches.begin(), request.switches.end());
  if (request.threads > 0) arguments.push_back(fmt::format("+WT{}", request.threads));
  for (const auto& path : request.library_paths) arguments.push_back("+L" + path.string());
  if (request.replay) arguments.push_back("--replay");
  if (request.seed)
    arguments.insert(arguments.end(), {"--seed", std::to_string(*request.seed)});
  else if (request.run > 0)
    arguments.insert(arguments.end(), {"--seed", std::to_string(request.run)});
  arguments.insert(arguments.end(), {"--allow-write", request.folder.string()});
  process.folder = request.folder;
  process.environment = current_environment();
  process.time_limit = request.time_limit;
  process.cancel = request.cancel;
  return process;
}

NativeRenderer native_program(const std::filesystem::path& program, const std::vector<std::string>& extra_arguments) {
  return [program, extra_arguments](const NativeRequest& request) {
    NativeResult out;
    const TemporaryFolder scratch;
    const std::filesystem::path statistics = scratch.path() / "stats.json";
    ProcessRequest process = program_call(program, "render", request);
    process.arguments.push_back("+O" + request.output.string());
    process.arguments.insert(process.arguments.end(), {"--stats", statistics.string()});
    process.arguments.insert(process.arguments.end(), extra_arguments.begin(), extra_arguments.end());
    const ProcessResult run = run_process(process);
    out.seconds = run.wall, out.cpu_seconds = run.cpu, out.peak_bytes = run.peak_bytes;
    read_statistics(statistics, out);
    if (run.succeeded()) {
      out.outcome = NativeResult::Outcome::rendered;
      out.console = run.err;
      return out;
    }
    out.message = message_of(run.err);
    out.ending = ending_of(run);
    const bool ended = run.started && !run.timed_out && !run.cancelled && run.signal == 0;
    if (ended && run.exit_code == 4) {
      out.outcome = NativeResult::Outcome::unsupported;
    } else if (!ended || out.message.empty()) {
      const bool says_why =
          !out.message.empty() && !run.timed_out && !run.cancelled;  // killed in the middle of whatever it was saying
      out.message = run.how_it_ended(request.time_limit) + (says_why ? ": " + out.message : "");
    }
    return out;
  };
}

}  // namespace verisim::compare
