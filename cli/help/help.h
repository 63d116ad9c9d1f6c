// What a command says of itself: one description, from which come `--help`, docs/cli.md, the man pages and the
// completion of the shell.
#pragma once

#include <string>
#include <vector>

namespace verisim::cli {

// One option: how it is written ("--seed N"; "+Wn", "Width=n"), and what it means.
struct HelpEntry {
  std::vector<std::string> spellings;
  std::string meaning;
};

// The option or keyword without its value: "--seed" of "--seed N", "Width=" of "Width=n"; empty for a switch ("+Wn").
std::string bare_option(const std::string& spelling);

struct HelpSection {
  std::string title;
  std::vector<HelpEntry> entries;
};

struct HelpExample {
  std::string call, meaning;
};

struct CommandHelp {
  std::string name;      // as in `verisim NAME`; empty: the call in POV-Ray's style
  std::string synopsis;  // what follows the name
  std::string summary;   // one line
  std::string description;
  std::vector<HelpSection> sections;
  std::vector<HelpExample> examples;
};

// Columns of words for a terminal: at most `columns` wide, meanings from one column on.
std::string help_text(const CommandHelp& command, int columns = 100);
// The commands as one page of Markdown; `general` describes the program as a whole.
std::string help_markdown(const CommandHelp& general, const std::vector<CommandHelp>& commands);
// A man page of section 1: verisim(1) or verisim-NAME(1). `others`: names of the pages to see also.
std::string help_man(const CommandHelp& command, const std::vector<std::string>& others);
// A completion script for bash: commands, `--` options, INI keywords, files.
std::string help_bash(const std::vector<CommandHelp>& commands);

// The statuses with which every command ends, as a section.
HelpSection exit_status_help();

}  // namespace verisim::cli
