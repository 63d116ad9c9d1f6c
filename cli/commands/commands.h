// The subcommands; each is in the file of its name. They return the exit status and throw OptionError for bad usage and
// HelpWanted for --help.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/console/exit_status.h"
#include "cli/help/help.h"

namespace verisim::cli {

int command_render(const std::vector<std::string>& arguments);
int command_check(const std::vector<std::string>& arguments);
int command_compare(const std::vector<std::string>& arguments);
int command_diff(const std::vector<std::string>& arguments);
int command_explain(const std::vector<std::string>& arguments);
int command_farm(const std::vector<std::string>& arguments);
int command_merge(const std::vector<std::string>& arguments);
int command_lsp(const std::vector<std::string>& arguments);
int command_view(const std::vector<std::string>& arguments);
int command_review(const std::vector<std::string>& arguments);
int command_bench(const std::vector<std::string>& arguments);
int command_help(const std::vector<std::string>& arguments);

struct Command {
  std::string_view name;
  int (*run)(const std::vector<std::string>&);
};
std::span<const Command> commands();

// The program as a whole, for `verisim --help` and its like.
CommandHelp program_help();
// `--version`; as JSON: the libraries and the instruction sets it uses, too.
std::string version_text(bool json);

// The call as `povray` is called: no subcommand. Exit status 0, 1, or 2 after an interrupt.
int povray_call(const std::vector<std::string>& arguments);

}  // namespace verisim::cli
