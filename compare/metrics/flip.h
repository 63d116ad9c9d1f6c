// LDR-FLIP (Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", HPG 2020) and HDR-FLIP
// ("Visualizing Errors in Rendered High Dynamic Range Images", Eurographics 2021).
#pragma once

#include <memory>
#include <vector>

#include "compare/metrics/values.h"

namespace verisim::compare {

inline constexpr double kDefaultPixelsPerDegree = 67.02064327658226;

// 0.7 m, 3840 pixels, 0.7 m -> 67.0206.
double pixels_per_degree(double distance_m, double screen_pixels, double screen_width_m);

// One error in 0..1 for each pixel, row by row. Throws PictureMismatch for different sizes and std::invalid_argument
// for pixels_per_degree <= 0.
std::vector<float> ldr_flip(const Picture& reference, const Picture& test,
                            double pixels_per_degree = kDefaultPixelsPerDegree);

struct Exposures {
  double start = 0, stop = 0;  // in stops, log2
  int count = 2;
};
// From the reference's luminances and the ACES curve: the brightest pixel, and the median one, are brought to 85 % of
// the tone mapper's range.
Exposures hdr_flip_exposures(const Picture& reference);
// Pictures of linear floats. The largest LDR-FLIP error over the exposures, per pixel.
std::vector<float> hdr_flip(const Picture& reference, const Picture& test,
                            double pixels_per_degree = kDefaultPixelsPerDegree);
std::vector<float> hdr_flip(const Picture& reference, const Picture& test, double pixels_per_degree,
                            const Exposures& exposures);

// FLIP of some rows of a picture at a time; the values do not depend on which.
class Flip {
 public:
  explicit Flip(double pixels_per_degree);  // throws std::invalid_argument unless it is positive
  ~Flip();
  int margin() const;  // rows above and below that the rows in question depend on
  // The rows from begin to end, one after the other in `out`.
  void ldr(const Values& reference, const Values& test, int begin, int end, float* out) const;
  void hdr(const Values& reference, const Values& test, const Exposures& exposures, int begin, int end,
           float* out) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

double mean(const std::vector<float>& values);

}  // namespace verisim::compare
