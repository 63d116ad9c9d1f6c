// A photograph brought into a render's pixels: perspective, the lens's radial distortion and its fall-off of light.
#pragma once

#include <span>

#include "compare/photographs/fit.h"

namespace verisim::compare {

// From points of the unit square (0, 0 at the upper left) to the photograph's pixels.
class Homography {
 public:
  // Throws PictureMismatch when the corners are no convex quadrilateral, clockwise from the upper left one.
  explicit Homography(const Corners& corners);
  ImagePoint operator()(double u, double v) const {
    const double w = m_[6] * u + m_[7] * v + 1;
    return {(m_[0] * u + m_[1] * v + m_[2]) / w, (m_[3] * u + m_[4] * v + m_[5]) / w};
  }

 private:
  std::array<double, 8> m_;
};

// Refines the corners (and finds the distortion) by Gauss-Newton on the luma, with one gain between the pictures;
// robust against parts that differ. The photograph may be of any size.
Alignment align(const Picture& photograph, const Picture& render, const Corners& start, bool distortion);
// The photograph where the alignment says that the render's pixels are, averaged over each (in linear light).
Picture aligned(const Picture& photograph, const Alignment& alignment, int width, int height);

// By least squares between the photograph in the render's pixels and the render, each channel with a gain of its own.
// `where` is how far each of the render's pixels lies from the photograph's centre, in half diagonals.
Vignetting fit_vignetting(const Picture& photograph, const Picture& render, std::span<const double> where);
// The same photograph without it.
Picture without_vignetting(const Picture& photograph, const Vignetting& vignetting, std::span<const double> where);
// For an alignment, or for a part that was cut out of the photograph.
std::vector<double> distances_from_centre(const Picture& photograph, const Alignment& alignment, int width, int height);
std::vector<double> distances_from_centre(const Picture& photograph, const Crop& part, int width, int height);

// Standard deviation of the noise, code values, by Immerkaer's operator, which is blind to edges and slopes ("Fast
// Noise Variance Estimation", 1996). 0 for pictures smaller than 3x3.
double estimate_noise(const Picture& picture);

}  // namespace verisim::compare
