// `verisim review`: the report of a run as a page that writes decisions.
#pragma once

#include <string>
#include <vector>

namespace verisim::cli {

// Serves until it is interrupted; the exit status says whether something is left. Throws OptionError, HelpWanted and
// std::runtime_error.
int review(const std::vector<std::string>& arguments);

}  // namespace verisim::cli
