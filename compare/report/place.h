// Where to look first: the place of a picture where the errors are worst together.
#pragma once

#include <optional>

#include "compare/metrics/values.h"

namespace verisim::compare {

struct Place {
  int x = 0, y = 0, width = 0, height = 0;
};

// The connected pixels around the largest 5x5 mean of the errors (largest channel difference) where that mean is at
// least half of it. Empty for pictures that are equal. Both of one size.
std::optional<Place> worst_place(const Values& reference, const Values& test);

}  // namespace verisim::compare
