// A render beside a photograph: a part of the photograph, cut out or found by the picture's four corners in it, and the
// exposure and white balance that bring the render nearest to it.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "compare/photographs/color_targets.h"
#include "compare/metrics/metrics.h"

namespace verisim::compare {

struct Crop {
  int x = 0, y = 0, width = 0, height = 0;
};

struct ImagePoint {
  double x = 0, y = 0;  // pixels; 0, 0 is the upper left corner of the upper left pixel
};
// Upper left, upper right, lower right, lower left.
using Corners = std::array<ImagePoint, 4>;

struct FitOptions {
  std::optional<Crop> crop;            // of the reference, in its pixels
  std::optional<Corners> corners;      // of the picture, where they are in the reference, about: they are refined
  bool distortion = false;             // with corners: the lens's radial distortion is fitted, too
  bool vignetting = false;             // the fall-off of light towards the corners is fitted
  bool exposure = false;               // one factor for the three channels
  bool white_balance = false;          // a factor for each channel; the exposure is then their part in common
  std::vector<ColorTarget> targets{};  // patches of known colours, in the picture's pixels
  bool any() const {
    return crop || corners || distortion || vignetting || exposure || white_balance || !targets.empty();
  }
};

// Where the picture lies in the photograph. Errors are standard deviations, from the residuals of the fit.
struct Alignment {
  Corners corners, corner_errors;
  // A point r half diagonals away from the photograph's centre is seen (1 + k r^2) times as far away: below 0, barrel.
  double distortion = 0, distortion_error = 0;
};
// r half diagonals away from the photograph's centre the photograph has 1 + a r^2 + b r^4 of the light.
struct Vignetting {
  double a = 0, b = 0, a_error = 0, b_error = 0;
};

// What was done, for the report.
struct Fit {
  std::optional<Crop> crop;
  int reference_width = 0, reference_height = 0;  // after the crop, before it was brought to the render's size
  bool resampled = false;
  std::optional<Alignment> alignment;
  std::optional<Vignetting> vignetting;
  std::optional<TargetFit> targets;
  double noise = 0;                        // standard deviation of the reference's, code values; 0: not estimated
  double stops_error = 0;                  // standard deviation
  double stops = 0;                        // exposure: the render's linear values were multiplied by 2^stops ...
  std::array<double, 3> balance{1, 1, 1};  // ... and by these, whose geometric mean is 1
  std::string text() const;                // for people
};

struct FittedPair {
  Picture reference, test;
  Fit fit;
};

// Averages in linear light over the area of each new pixel. Integer pictures come out with 16 bits.
Picture resampled(const Picture& picture, int width, int height);

// Least squares in linear light over the pixels that are clipped in neither picture. A cut-out of another size is
// averaged over the render's pixels. Throws PictureMismatch when the crop is not inside the reference, or the corners
// are no convex quadrilateral in their order, or of fit_targets.
FittedPair fit_to_reference(const Picture& reference, const Picture& test, const FitOptions& options);

}  // namespace verisim::compare
