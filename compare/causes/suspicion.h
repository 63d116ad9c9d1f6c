// A cause that is suspected of a difference, how sure that is, and which pixels it explains.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace verisim::compare {

// Pixels of a picture, row by row from the upper left corner: so many that do not belong, so many that do, and so on.
using PixelRuns = std::vector<std::uint32_t>;
PixelRuns runs_of(const std::vector<unsigned char>& mask);
std::vector<unsigned char> mask_of(const PixelRuns& runs, std::size_t pixels);  // what the runs do not reach is 0

struct Suspicion {
  std::string what;       // "gamma", "object moved", "light", "tile" ...: docs/comparison.md has the list
  std::string detail;     // for people: "the picture is moved by 0.50, 0.00 pixels"
  double explained = 0;   // 0..1: part of the squared difference that is gone when the fault is undone, or that lies on
                          // the pixels which it predicts to be wrong
  double precision = 1;   // 0..1: part of the pixels that it predicts to be wrong and that are
  double sure = 0;        // 0..1, by both and by how much the hypothesis says; suspects are ordered by it
  PixelRuns pixels = {};  // those that it explains; empty: not known
};

}  // namespace verisim::compare
