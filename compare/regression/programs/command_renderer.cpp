#include "compare/regression/programs/command_renderer.h"

#include <fmt/format.h>
#include <unistd.h>

#include "compare/oracle/process.h"

namespace verisim::compare {
namespace {

using Words = std::map<std::string, std::string>;

std::string filled(const std::string& command, const Words& words) {
  std::string out;
  for (std::size_t at = 0; at < command.size(); ++at) {
    if (command[at] != '{') {
      out += command[at];
    } else if (command.compare(at, 2, "{{") == 0) {
      out += '{', ++at;
    } else {
      const std::size_t end = command.find('}', at);
      const auto word = words.find(command.substr(at + 1, end == std::string::npos ? end : end - at - 1));
      if (end == std::string::npos || word == words.end())
        throw std::invalid_argument(fmt::format(
            "'{}': known are {{scene}}, {{out}}, {{width}}, {{height}}, {{threads}}, {{seed}} and {{switches}}",
            command.substr(at, end - at + 1)));
      out += word->second, at = end;
    }
  }
  return out;
}

Words words_of(const NativeRequest& request) {
  std::string switches;
  for (const std::string& s : request.switches) switches += (switches.empty() ? "" : " ") + shell_quoted(s);
  return {{"scene", shell_quoted(request.scene.string())},
          {"out", shell_quoted(request.output.string())},
          {"width", std::to_string(request.width)},
          {"height", std::to_string(request.height)},
          {"threads", std::to_string(request.threads)},
          {"seed", std::to_string(request.run)},
          {"switches", switches}};
}

std::vector<std::pair<std::string, std::string>> own_environment() {
  std::vector<std::pair<std::string, std::string>> out;
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry;
    if (const std::size_t equals = text.find('='); equals != std::string::npos)
      out.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  return out;
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \r\n\t");
  if (end == std::string::npos) return "";
  const std::size_t begin = text.rfind('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1,
                     end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

}  // namespace

NativeRenderer command_renderer(const std::string& command) {
  filled(command, words_of({}));
  if (command.find("{scene}") == std::string::npos || command.find("{out}") == std::string::npos)
    throw std::invalid_argument("the command must say where {scene} and {out} belong");
  return [command](const NativeRequest& request) {
    NativeResult out;
    const ProcessResult run = run_process({{"/bin/sh", "-c", filled(command, words_of(request))},
                                           request.folder,
                                           own_environment(),
                                           request.time_limit,
                                           request.cancel});
    out.seconds = run.wall, out.cpu_seconds = run.cpu, out.peak_bytes = run.peak_bytes;
    if (run.succeeded())
      out.outcome = NativeResult::Outcome::rendered;
    else
      out.message =
          run.how_it_ended(request.time_limit) + (last_line(run.err).empty() ? "" : ": " + last_line(run.err));
    return out;
  };
}

}  // namespace verisim::compare
