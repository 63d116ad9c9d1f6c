#include "cli/console/shellout.h"

#include <cstdlib>

#include <fmt/format.h>

#include "cli/settings/text.h"

namespace verisim::cli {

std::string expand(const std::string& command, const ShellContext& context) {
  if (!command.empty() && command.back() == '&')
    throw OptionError("Background execution of shellout commands not currently supported");
  const std::size_t parameters = std::min(command.find(' '), command.size());
  std::string result = command.substr(0, parameters);
  for (std::size_t i = parameters; i < command.size(); ++i) {
    if (command[i] != '%' || i + 1 == command.size()) {
      result += command[i];
      continue;
    }
    switch (command[++i]) {
      case 'o':
        result += context.output;
        break;
      case 's':
        result += context.scene;
        break;
      case 'n':
        result += std::to_string(context.frame);
        break;
      case 'k':
        result += fmt::format("{:#.6f}", context.clock);
        break;
      case 'h':
        result += std::to_string(context.height);
        break;
      case 'w':
        result += std::to_string(context.width);
        break;
      default:
        result += '%', result += command[i];
    }
  }
  return result;
}

char shell_out(const ShellCommand& command, const ShellContext& context, bool allowed, Console& console) {
  const std::string text(trim(command.command));
  if (text.empty()) return 'I';
  const std::string line = expand(text, context);
  if (!allowed) {
    console.line(Stream::warning,
                 wrapped(fmt::format("Execution of shellout '{}' prohibited (--allow-shell permits it)", line)));
  } else {
    std::fflush(nullptr);
    [[maybe_unused]] const int status = std::system(line.c_str());  // POV-Ray does not look at it either
  }
  return command.negated ? 'I' : command.action;
}

}  // namespace verisim::cli
