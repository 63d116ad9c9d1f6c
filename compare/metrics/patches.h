// Errors that lie together. POV-Ray's own speckle (coincident surfaces, patterns that hang on a last bit) is lone wrong
// pixels; a missing object or a wrong tile is a patch of them, and a finish that is a little too dark is a patch of
// differences to one side, however small each is.
#pragma once

#include "compare/metrics/values.h"

namespace verisim::compare {

// Whole code values where only one of the pictures has fractions: what the other one rounded away is no difference.
Rgb told_difference(const Values& reference, const Values& test, int x, int y);

struct Patches {
  // The median of the differences of 3x3 pixels, in any channel: lone pixels and lines one pixel wide leave nothing of
  // it.
  double solid_max = 0;                                  // the largest
  std::uint64_t solid_2_pixels = 0, solid_4_pixels = 0;  // where it is above 2 (4) code values
  int solid_x = 0, solid_y = 0;                          // where it is largest
  // The mean difference of 16x16 pixels (every 8 pixels in both directions), each channel by itself and clipped to one
  // code value, so that few wrong pixels count little.
  double drift_max = 0;          // the largest
  int drift_x = 0, drift_y = 0;  // centre of that block

  void add(const Patches& other);
};

// What the rows from begin to end - 1 hold; begin is a multiple of 8, and kPatchMargin rows more are known above and
// below.
inline constexpr int kPatchMargin = 10;
Patches patches(const Values& reference, const Values& test, int begin, int end);

}  // namespace verisim::compare
