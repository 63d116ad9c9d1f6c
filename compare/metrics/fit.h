// A render beside a photograph: a cut-out of the photograph, and the exposure and white balance that bring the render
// nearest to it.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "compare/metrics/metrics.h"

namespace verisim::compare {

struct Crop {
  int x = 0, y = 0, width = 0, height = 0;
};

struct FitOptions {
  std::optional<Crop> crop;    // of the reference, in its pixels
  bool exposure = false;       // one factor for the three channels
  bool white_balance = false;  // a factor for each channel; the exposure is then their part in common
  bool any() const { return crop || exposure || white_balance; }
};

// What was done, for the report.
struct Fit {
  std::optional<Crop> crop;
  int reference_width = 0, reference_height = 0;  // after the crop, before it was brought to the render's size
  bool resampled = false;
  double stops = 0;                        // exposure: the render's linear values were multiplied by 2^stops ...
  std::array<double, 3> balance{1, 1, 1};  // ... and by these, whose geometric mean is 1
  std::string text() const;                // for people
};

struct FittedPair {
  Picture reference, test;
  Fit fit;
};

// Least squares in linear light over the pixels that are clipped in neither picture. A cut-out of another size is
// averaged over the render's pixels. Throws PictureMismatch when the crop is not inside the reference.
FittedPair fit_to_reference(const Picture& reference, const Picture& test, const FitOptions& options);

}  // namespace verisim::compare
