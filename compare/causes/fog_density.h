// How much thicker or thinner a fog must be to be what another picture shows.
#pragma once

#include <optional>

#include "compare/causes/case.h"

namespace verisim::compare {

struct OtherFog {
  double density = 1;  // so many times as much as it is
  Pixels change;       // linear: what every pixel has more with it
};

// `all` is the light of each pixel, `fog` what the fog adds to it and `more` what another picture has more, all linear.
// What passes a fog is a power of what passes another of the same kind; what the thickest of it adds is its colour.
// Nothing where another density is hardly better.
std::optional<OtherFog> other_fog(const Pixels& all, const Pixels& fog, const Pixels& more, const Mask& judged);

}  // namespace verisim::compare
