// Completion for bash, without the package bash-completion's helper functions.
#include <fmt/format.h>

#include "cli/help/help.h"

namespace verisim::cli {
namespace {

std::string words_of(const CommandHelp& command) {
  std::string words = "--help";
  for (const HelpSection& section : command.sections)
    for (const HelpEntry& entry : section.entries)
      for (const std::string& spelling : entry.spellings)
        if (const std::string word = bare_option(spelling); !word.empty() && word != "--help") words += " " + word;
  return words;
}

}  // namespace

std::string help_bash(const std::vector<CommandHelp>& commands) {
  std::string names, cases;
  for (const CommandHelp& command : commands) {
    if (!command.name.empty()) names += (names.empty() ? "" : " ") + command.name;
    cases += fmt::format("    {}) words='{}' ;;\n", command.name.empty() ? "*" : command.name, words_of(command));
  }
  return "# bash completion for verisim; made by `verisim help --format bash`\n"
         "_verisim() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} words\n"
         "  COMPREPLY=()\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ] && [[ $current != [-+]* ]]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W '" +
         names +
         " help' -- \"$current\"; compgen -f -X '!*.pov' -- \"$current\"; compgen -d -- \"$current\")\n"
         "    return\n"
         "  fi\n"
         "  case ${COMP_WORDS[1]} in\n"
         "    help) words='" +
         names + "' ;;\n" + cases +
         "  esac\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\"; compgen -f -- \"$current\")\n"
         "  # Settings go on after their equals sign.\n"
         "  [ \"${#COMPREPLY[@]}\" -eq 1 ] && [[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace\n"
         "  return 0\n"
         "}\n"
         "complete -o filenames -F _verisim verisim\n";
}

}  // namespace verisim::cli
