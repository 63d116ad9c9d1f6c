// The luma of a colour with POV-Ray's last bit: weighed in double precision and rounded once. Rgb::grey() and
// Color::grey() may be one unit beside it, which nothing but heights and patterns shows.
#pragma once

#include "tracer/math/color.h"

namespace verisim {

inline float luma(const Color& c) {
  return static_cast<float>(0.297 * static_cast<double>(c.r) + 0.589 * static_cast<double>(c.g) +
                            0.114 * static_cast<double>(c.b));
}

}  // namespace verisim
