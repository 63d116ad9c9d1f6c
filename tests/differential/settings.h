// Numbers that the environment may give to long tests.
#pragma once

#include <cstdlib>

namespace verisim {

inline int setting(const char* name, int absent) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : absent;
}

}  // namespace verisim
