// Structural similarity (Wang, Bovik, Sheikh, Simoncelli: "Image Quality Assessment: From Error Visibility to
// Structural Similarity", 2004) of the luma, K1 = 0.01, K2 = 0.03, L = 255.
#pragma once

#include "compare/metrics/values.h"

namespace verisim::compare {

// Mean over all 11x11 windows inside the picture, weighted by a Gaussian of sigma 1.5. A side shorter than 11 takes a
// window as long as the side.
double ssim_mean(const Values& reference, const Values& test);
// The sum over the windows whose last row is from begin to end, and their number over the whole picture; needs the 10
// rows above.
double ssim_sum(const Values& reference, const Values& test, int begin, int end);
double ssim_windows(int width, int height);
// The SSIM of the window around each pixel, row by row; at the border that of the nearest window inside.
std::vector<float> ssim_map(const Values& reference, const Values& test);

// The smallest SSIM of the 8x8 blocks the picture is divided into from its upper left corner; smaller blocks remain at
// the right and lower border.
double ssim_block_min(const Values& reference, const Values& test);
double ssim_block_min(const Values& reference, const Values& test, int begin,
                      int end);  // of the rows from begin, a multiple of 8, to end

}  // namespace verisim::compare
