// What a fuzzer's input must not break.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <new>
#include <stdexcept>

namespace verisim::fuzz {

inline void require(bool promise, const char* what) {
  if (promise) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

// Runs what may end by an error of its own kind, or without memory.
template <class Run>
void may_throw(Run&& run) {
  try {
    run();
  } catch (const std::runtime_error&) {
  } catch (const std::bad_alloc&) {
  }
}

}  // namespace verisim::fuzz
