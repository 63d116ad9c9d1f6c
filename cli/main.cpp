#include <sys/resource.h>

#include <algorithm>

#include "cli/program.h"

namespace {

// Objects may be within objects some thousand levels deep (kMaxObjectLevels), and walks over them are recursive. Only
// what is used of the stack takes memory.
void raise_stack_limit() {
  rlimit limit{};
  constexpr rlim_t kWanted = rlim_t{100} << 20;
  if (::getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= kWanted) return;
  limit.rlim_cur = std::min(kWanted, limit.rlim_max);
  ::setrlimit(RLIMIT_STACK, &limit);
}

}  // namespace

int main(int argc, char** argv) {
  raise_stack_limit();
  return verisim::cli::run({argv, argv + argc});
}
