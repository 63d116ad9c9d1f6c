#include <pthread.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <thread>

#include "cli/program.h"

namespace {

// Objects may be within objects some thousand levels deep (kMaxObjectLevels), and walks over them are recursive. Only
// what is used of a stack takes memory.
constexpr std::size_t kStack = std::size_t{100} << 20;

// Of threads that are started from now on.
void set_stacks_of_threads() {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStack);
  pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
}

// Of the first thread; false: nobody may have as much here.
bool raise_own_stack() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_STACK, &limit) != 0) return false;
  if (limit.rlim_cur >= kStack) return true;
  limit.rlim_cur = std::min<rlim_t>(kStack, limit.rlim_max);
  return ::setrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur == kStack;
}

}  // namespace

int main(int argc, char** argv) {
  set_stacks_of_threads();
  int status = 0;
  const auto run = [&] { status = verisim::cli::run({argv, argv + argc}); };
  if (raise_own_stack())
    run();
  else
    std::thread(run).join();
  return status;
}
