// Pre_Scene_Command and its like (spec 02 section 11).
#pragma once

#include <string>

#include "cli/console/console.h"
#include "cli/settings/options.h"

namespace verisim::cli {

struct ShellContext {
  std::string output, scene;
  int frame = 0, width = 0, height = 0;
  double clock = 0;
};

// The command with %o %s %n %k %h %w replaced after its first word. Throws OptionError for a trailing '&'.
std::string expand(const std::string& command, const ShellContext& context);

// Runs the command (if there is one and --allow-shell was given) and returns the letter of what is to happen now: I, S,
// A, Q, U or F. As in POV-Ray 3.7 every command counts as failed: a return rule always fires, a negated one never.
char shell_out(const ShellCommand& command, const ShellContext& context, bool allowed, Console& console);

}  // namespace verisim::cli
