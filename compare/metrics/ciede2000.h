// The CIEDE2000 colour difference (Sharma, Wu, Dalal: "The CIEDE2000 Color-Difference Formula: Implementation Notes,
// Supplementary Test Data, and Mathematical Observations", 2005).
#pragma once

#include "compare/metrics/values.h"

namespace verisim::compare {

using Lab = std::array<double, 3>;

// sRGB, 0..255, to CIE L*a*b* (D65).
Lab srgb_to_lab(const Rgb& value);
double ciede2000(const Lab& a, const Lab& b);

}  // namespace verisim::compare
