// The part of the picture that is rendered (spec 02 section 3.6).
#pragma once

#include "cli/settings/options.h"

namespace verisim::cli {

struct Region {  // inclusive, zero-based; empty when last < first
  int first_column = 0, last_column = 0, first_row = 0, last_row = 0;
  bool empty() const { return last_column < first_column || last_row < first_row; }
};

// Throws OptionError when it lies outside of the picture.
Region region(const Options& options);

}  // namespace verisim::cli
