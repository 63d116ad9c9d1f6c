// A colour chart in a photograph: patches of known colours, by which the camera's colours are mended.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "compare/metrics/metrics.h"

namespace verisim::compare {

struct ColorTarget {
  int x = 0, y = 0, width = 0, height = 0;  // in the render's pixels, within the patch
  std::array<double, 3> srgb{};             // what it is known to be, 0..255
};

struct TargetFit {
  // By rows; on the photograph's linear values, whose mean luminance over the targets it keeps.
  std::array<double, 9> matrix{1, 0, 0, 0, 1, 0, 0, 0, 1};
  bool whole_matrix = false;   // else only a factor for each channel
  std::vector<double> errors;  // CIEDE2000 of each target from its known colour, after the fit
  std::string text() const;    // for people
};

// Least squares in linear light over the means of the patches: a matrix of four targets or more, of fewer (or of greys
// alone) a factor for each channel. Throws PictureMismatch when a target is not in the picture, or clipped or black in
// the photograph.
TargetFit fit_targets(const Picture& photograph, std::span<const ColorTarget> targets);
Picture with_mended_colors(const Picture& photograph, const TargetFit& fit);

// "X,Y,WIDTH,HEIGHT=R,G,B"; throws std::invalid_argument that says what was expected.
ColorTarget color_target_of(const std::string& text);

}  // namespace verisim::compare
