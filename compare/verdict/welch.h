// Welch's test: do several renders of one program and several of another have the same mean? Noise is estimated from
// the renders themselves.
#pragma once

#include <string>
#include <vector>

#include "compare/metrics/metrics.h"

namespace verisim::compare {

struct WelchResult {
  bool rejected = false;         // the means differ
  double pixel_p = 1;            // smallest p-value over all pixels, corrected for their number (Sidak)
  int worst_x = 0, worst_y = 0;  // where
  double mean_p = 1;             // p-value of the pictures' means
  double mean_difference = 0;    // test - reference, 8-bit units
  std::string text() const;      // what it found, for people
};

// Two tests share the significance level: one for each pixel's luma, corrected for the number of pixels, which finds
// local faults; one for the mean of the whole picture, which finds a small fault that is everywhere. A variance is at
// least that of rounding to whole code values, 1/12; that of a picture's mean at least (0.05)^2, since deterministic
// parts round alike in every run. A rejection counts only if no other way to divide the same runs into two sides of
// these sizes is as unlikely (of many runs, the first 400 ways are tried): noise need not be normal, but runs of one
// renderer can be exchanged. At least two pictures on each side, all of one size; throws PictureMismatch.
WelchResult welch_test(const std::vector<Picture>& reference, const std::vector<Picture>& test,
                       double significance = 0.02);

// The p-value of each pixel's luma by itself, not corrected for their number. The same pictures as for welch_test.
std::vector<float> pixel_p_values(const std::vector<Picture>& reference, const std::vector<Picture>& test);

// P(|T| >= |t|) of Student's distribution.
double student_two_sided(double t, double degrees_of_freedom);

}  // namespace verisim::compare
