// Dispersion: how white is split into wavelengths, and the index ratio at each (spec 06 section 6.5).
#pragma once

#include "tracer/math/color.h"

namespace verisim::shading {

inline constexpr double kRedWavelength = 730, kVioletWavelength = 380;  // nm

// Cumulative hue from 375 nm up to `wavelength`: white is hue(740) - hue(375).
Rgb cumulative_hue(double wavelength);
// Weight of sub-ray i of n: n * (H(lambda + w/2) - H(lambda - w/2)), w = 350/n.
Rgb spectral_weight(int i, int n);
inline double spectral_wavelength(int i, int n) { return kVioletWavelength + 350 * (i + 0.5) / n; }
// Ratio of the indices (from over to) at a wavelength; `ratio` holds at 555 nm, `dispersion` is the relative
// dispersion.
double ratio_at(double ratio, double dispersion, double wavelength);

}  // namespace verisim::shading
