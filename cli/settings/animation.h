// Which frames are rendered and what clock each one has (spec 02 section 10).
#pragma once

#include <vector>

#include "cli/settings/options.h"

namespace verisim::cli {

struct Frame {
  int number = 0;
  double clock = 0;  // single precision, as POV-Ray's
};

struct Animation {
  bool on = false;
  bool clock_on = false;  // the SDL variable
  int initial_frame = 0, final_frame = 0;
  double initial_clock = 0, final_clock = 0, clock_delta = 0;
  int digits = 0;  // of the frame number in file names
  int first = 0, last = 0, step = 1;

  std::size_t count() const {
    return !on ? 1 : last < first ? 0 : static_cast<std::size_t>((static_cast<long>(last) - first) / step + 1);
  }
  Frame frame(std::size_t index) const;
  double single_clock = 0;  // without animation
};

// Throws OptionError for frames that cannot be.
Animation animation(const Options& options);

}  // namespace verisim::cli
