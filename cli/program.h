// The program as a function: what main() calls, and tests, too.
#pragma once

#include <string>
#include <vector>

#include "cli/console/exit_status.h"

namespace verisim::cli {

// arguments[0] is the name the program was called by.
int run(const std::vector<std::string>& arguments);

}  // namespace verisim::cli
