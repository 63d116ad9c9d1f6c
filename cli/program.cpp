#include "cli/program.h"

#include <cstdio>

namespace verisim::cli {

int run(const std::vector<std::string>& arguments) {
  std::fprintf(stderr, "%s: nothing to do\n", arguments.empty() ? "verisim" : arguments[0].c_str());
  return kUsage;
}

}  // namespace verisim::cli
