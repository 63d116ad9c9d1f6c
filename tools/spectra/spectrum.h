// Measured spectra to colour: the CIE 1931 observer, and what linear sRGB values a renderer with three channels should
// use.
//
// A reflectance becomes the colour that it has under an illuminant, relative to a perfect white under the same
// illuminant; a perfect white is therefore (1, 1, 1). Under D65 (the white of sRGB) nothing more is needed; under the
// equal-energy illuminant E the white is adapted to D65 (Bradford). An emission becomes the colour that the light
// itself has, with the white of sRGB as reference.
#pragma once

#include <array>
#include <utility>
#include <vector>

namespace verisim::spectra {

using Triple = std::array<double, 3>;  // X Y Z or R G B

// (wavelength in nm, value), ascending. Linear in between; constant below the first and above the last sample.
using Spectrum = std::vector<std::pair<double, double>>;

enum class Illuminant { d65, e };

double value_at(const Spectrum& spectrum, double nanometres);

// Sum over the visible range (380 to 780 nm, steps of 1 nm) of emission times reflectance times the observer's
// functions. Emission and reflectance are given as spectra; an empty one counts as 1. Not normalised: the Y of emission
// 1 is 106.86.
Triple integrate(const Spectrum& emission, const Spectrum& reflectance);

// Relative spectral power of the illuminant.
const Spectrum& power(Illuminant illuminant);

// Linear sRGB of a reflectance: a perfect white gives (1, 1, 1).
Triple reflectance_to_rgb(const Spectrum& reflectance, Illuminant illuminant = Illuminant::d65);

// Linear sRGB of a light, scaled so that its luminance Y is 1.
Triple emission_to_rgb(const Spectrum& emission);

// IEC 61966-2-1: XYZ relative to D65 with Y = 1 to linear sRGB.
Triple xyz_to_rgb(const Triple& xyz);
// Bradford adaptation from one white to another.
Triple adapt(const Triple& xyz, const Triple& from_white, const Triple& to_white);

// The observer at 380, 385 ... 780 nm, and linear in between.
const std::array<Triple, 81>& observer();
Triple observer_at(double nanometres);

}  // namespace verisim::spectra
