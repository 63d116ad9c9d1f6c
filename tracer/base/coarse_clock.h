// A clock for those who ask all the time whether to look at something: some milliseconds coarse, some nanoseconds
// cheap.
#pragma once

#include <time.h>

#include <cstdint>

namespace verisim {

inline std::int64_t coarse_milliseconds() {
#ifdef CLOCK_MONOTONIC_COARSE
  constexpr clockid_t kClock = CLOCK_MONOTONIC_COARSE;
#else
  constexpr clockid_t kClock = CLOCK_MONOTONIC;
#endif
  timespec now;
  ::clock_gettime(kClock, &now);
  return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1000000;
}

}  // namespace verisim
