// `--help`: words in two columns.
#include <algorithm>

#include <fmt/format.h>

#include "cli/help/help.h"

namespace verisim::cli {
namespace {

constexpr std::size_t kMeaningColumn = 34;  // of the meanings

// The text broken at blanks; the first line begins at column `at`, all others at `indent`.
std::string filled(const std::string& text, std::size_t at, std::size_t indent, std::size_t columns) {
  std::string result;
  std::size_t column = at;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (column > indent && column + 1 + word.size() > columns) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
    begin = end + 1;
  }
  return result;
}

std::string entry_text(const HelpEntry& entry, std::size_t columns) {
  std::string left = "  ";
  for (const std::string& spelling : entry.spellings) left += (left.size() > 2 ? ", " : "") + spelling;
  if (left.size() + 2 > kMeaningColumn)
    left += "\n" + std::string(kMeaningColumn, ' ');
  else
    left.resize(kMeaningColumn, ' ');
  return left + filled(entry.meaning, kMeaningColumn, kMeaningColumn, columns) + "\n";
}

}  // namespace

std::string bare_option(const std::string& spelling) {
  if (spelling.starts_with("--")) return spelling.substr(0, spelling.find_first_of(" ["));
  const std::size_t equals = spelling.find('=');
  return equals == std::string::npos ? std::string() : spelling.substr(0, equals + 1);
}

std::string help_text(const CommandHelp& command, int columns) {
  const auto width = static_cast<std::size_t>(std::max(columns, 60));
  std::string text = fmt::format("Usage: verisim{}{} {}\n\n{}\n", command.name.empty() ? "" : " ", command.name,
                                 command.synopsis, filled(command.description, 0, 0, width));
  if (!command.examples.empty()) text += "\nExamples:\n";
  for (const HelpExample& example : command.examples)
    text += fmt::format("  {}\n      {}\n", example.call, filled(example.meaning, 6, 6, width));
  for (const HelpSection& section : command.sections) {
    text += "\n" + section.title + ":\n";
    for (const HelpEntry& entry : section.entries) text += entry_text(entry, width);
  }
  return text;
}

HelpSection exit_status_help() {
  return {"Exit status",
          {{{"0"}, "done"},
           {{"1"}, "a comparison or a threshold failed"},
           {{"2"}, "bad usage: the message says what is wrong and what is right"},
           {{"3"}, "the scene has errors"},
           {{"4"}, "the scene uses something that verisim does not support: named, with its place"},
           {{"5"}, "a file cannot be read or written"},
           {{"130"}, "interrupted, or out of the time of --max-seconds"}}};
}

}  // namespace verisim::cli
