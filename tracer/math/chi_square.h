// Chi-square quantiles as POV-Ray computes them for focal blur and media (spec 02 section 2.3, 07 section 4.6).
#pragma once

namespace verisim {

// The value that a chi-square variable of `freedom` >= 1 degrees exceeds with probability `confidence`, 0 <= confidence
// < 1. For odd degrees up to 25 POV-Ray's incomplete gamma function is off by a constant factor; pictures show it, so
// it is reproduced.
double chi_square_quantile(int freedom, double confidence);

}  // namespace verisim
