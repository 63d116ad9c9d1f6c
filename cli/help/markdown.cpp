// docs/cli.md.
#include <fmt/format.h>

#include "cli/help/help.h"

namespace verisim::cli {
namespace {

// What Markdown would take for markup in running text.
std::string escaped_markdown(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '*' || c == '_') result += '\\';
    result += c;
  }
  return result;
}

// Bars divide cells even in code.
std::string code(const std::string& text) {
  std::string result = "`";
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result + "`";
}

std::string section_markdown(const HelpSection& section) {
  std::string text = fmt::format("\n**{}**\n\n| | |\n| --- | --- |\n", section.title);
  for (const HelpEntry& entry : section.entries) {
    std::string left;
    for (const std::string& spelling : entry.spellings) left += (left.empty() ? "" : ", ") + code(spelling);
    text += fmt::format("| {} | {} |\n", left, escaped_markdown(entry.meaning));
  }
  return text;
}

std::string body(const CommandHelp& command) {
  std::string text = fmt::format("```sh\nverisim{}{} {}\n```\n\n{}\n", command.name.empty() ? "" : " ", command.name,
                                 command.synopsis, escaped_markdown(command.description));
  if (!command.examples.empty()) {
    text += "\n```sh\n";
    for (const HelpExample& example : command.examples)
      text += fmt::format("{}  # {}\n", example.call, example.meaning);
    text += "```\n";
  }
  for (const HelpSection& section : command.sections) text += section_markdown(section);
  return text;
}

}  // namespace

std::string help_markdown(const CommandHelp& general, const std::vector<CommandHelp>& commands) {
  std::string text =
      "<!-- Made by `verisim help --format markdown`; a test compares it with what the program says. -->\n"
      "# The command line\n\n";
  text += body(general);
  for (const CommandHelp& command : commands) text += fmt::format("\n## verisim {}\n\n{}", command.name, body(command));
  return text;
}

}  // namespace verisim::cli
