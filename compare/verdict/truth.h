// Pictures with a known answer: values that mathematics gives for some pixels, and how far a render is from them. This
// says who is right, not only who differs.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "compare/metrics/metrics.h"

namespace verisim::compare {

struct TruthPoint {
  int x = 0, y = 0;
  std::array<double, 3>
      value{};  // as the file stores it, 0..1: of a scene rendered with File_Gamma=1 that is linear radiance
};

struct Truth {
  std::string formula;  // where the numbers come from, for the report
  std::vector<TruthPoint> points;
  double tolerance = 1e-3;  // largest difference that is allowed
};

struct TruthError {
  double max = 0, rms = 0;  // over the points and channels, in stored units (0..1)
  int worst_x = 0, worst_y = 0;
  std::vector<std::array<double, 3>> values;  // of the picture at the points, in their order
};

// Throws PictureMismatch when a point is outside the picture.
TruthError truth_error(const Picture& picture, const Truth& truth);

}  // namespace verisim::compare
