// Man pages in roff (man(7)).
#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "cli/help/help.h"

namespace verisim::cli {
namespace {

// Backslashes, hyphens that are typed as such, and dots and quotes that would begin a request.
std::string escaped(const std::string& text) {
  std::string result;
  if (!text.empty() && (text.front() == '.' || text.front() == '\'')) result = "\\&";
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if (c == '\'')
      result += "\\(aq";
    else
      result += c;
  }
  return result;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string section_man(const HelpSection& section) {
  std::string text = ".SH \"" + escaped(upper(section.title)) + "\"\n";
  for (const HelpEntry& entry : section.entries) {
    text += ".TP\n";
    std::string left;
    for (const std::string& spelling : entry.spellings)
      left += (left.empty() ? "" : ", ") + ("\\fB" + escaped(spelling) + "\\fR");
    text += left + "\n" + escaped(entry.meaning) + "\n";
  }
  return text;
}

std::string page_name(const std::string& command) { return command.empty() ? "verisim" : "verisim-" + command; }

}  // namespace

std::string help_man(const CommandHelp& command, const std::vector<std::string>& others) {
  const std::string page = page_name(command.name);
  std::string text =
      fmt::format(".TH {} 1 \"\" \"verisim {}\" \"User Commands\"\n", upper(escaped(page)), VERISIM_VERSION);
  text += fmt::format(".SH NAME\n{} \\- {}\n", escaped(page), escaped(command.summary));
  text += fmt::format(".SH SYNOPSIS\n.B verisim{}{}\n{}\n", command.name.empty() ? "" : " ", escaped(command.name),
                      escaped(command.synopsis));
  text += ".SH DESCRIPTION\n" + escaped(command.description) + "\n";
  for (const HelpSection& section : command.sections) text += section_man(section);
  if (!command.examples.empty()) text += ".SH EXAMPLES\n";
  for (const HelpExample& example : command.examples)
    text += fmt::format(".TP\n.B {}\n{}\n", escaped(example.call), escaped(example.meaning));
  text += ".SH \"SEE ALSO\"\n";
  std::string list;
  for (const std::string& other : others)
    if (page_name(other) != page)
      list += fmt::format("{}.BR {} (1)", list.empty() ? "" : ",\n", escaped(page_name(other)));
  return text + list + "\n";
}

}  // namespace verisim::cli
