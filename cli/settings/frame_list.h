// --frames LIST: the frames that one of many calls renders, as Open Job Description writes ranges of integers.
#pragma once

#include <string>
#include <vector>

namespace verisim::cli {

// "7", "1-10", "1-9:2", and several of them with commas between, as numbers first, last, step (at least 1).
struct FrameRange {
  int first = 0, last = 0, step = 1;
  bool holds(int frame) const { return frame >= first && frame <= last && (frame - first) % step == 0; }
};

// Throws OptionError.
std::vector<FrameRange> frame_list(const std::string& text);

}  // namespace verisim::cli
