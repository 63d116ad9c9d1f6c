// The C library's rand() as POV-Ray on Linux finds it: never seeded, so seed 1. The additive feedback generator of
// degree 31 (glibc's manual, BSD random).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace verisim::global {

class CLibraryRandom {
 public:
  CLibraryRandom() {
    std::int64_t word = 1;
    for (std::uint32_t& w : state_) w = static_cast<std::uint32_t>(word), word = word * 16807 % 2147483647;
    for (int i = 0; i < 310; ++i) next();
  }
  std::size_t operator()() { return next() >> 1; }

 private:
  std::uint32_t next() {
    const std::uint32_t sum = state_[at_] += state_[(at_ + 28) % 31];  // the words 31 and 3 steps back
    at_ = (at_ + 1) % 31;
    return sum;
  }
  std::array<std::uint32_t, 31> state_;
  std::size_t at_ = 3;
};

}  // namespace verisim::global
