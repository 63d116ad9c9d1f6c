// The subcommands; each is in the file of its name. They return the exit status and throw OptionError for bad usage.
#pragma once

#include <string>
#include <vector>

#include "cli/console/exit_status.h"

namespace verisim::cli {

int command_render(const std::vector<std::string>& arguments);
int command_check(const std::vector<std::string>& arguments);
int command_compare(const std::vector<std::string>& arguments);
int command_diff(const std::vector<std::string>& arguments);
int command_explain(const std::vector<std::string>& arguments);
int command_bench(const std::vector<std::string>& arguments);

// The call as `povray` is called: no subcommand. Exit status 0, 1, or 2 after an interrupt.
int povray_call(const std::vector<std::string>& arguments);

}  // namespace verisim::cli
