// How the light that terms tell of was written into pictures.
#pragma once

#include "compare/causes/case.h"

namespace verisim::compare {

// From linear light to the code values of the pictures: sRGB, or linear files.
class Transfer {
 public:
  // The one that brings the sum of the terms nearest to the picture.
  Transfer(const Case& c, const Pixels& sum, const Pixels& picture) {
    double srgb = 0, plain = 0;
    for (std::size_t i = 0; i < c.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        srgb += std::fabs(coded(sum[i][k]) - picture[i][k]),
            plain += std::fabs(255 * std::clamp(sum[i][k], 0.0f, 1.0f) - picture[i][k]);
    linear_ = plain < srgb;
  }
  double light(float code) const { return linear_ ? code / 255 : srgb_to_linear(code / 255); }
  float code(double light) const {
    return linear_ ? static_cast<float>(255 * std::clamp(light, 0.0, 1.0)) : coded(light);
  }

 private:
  static float coded(double v) { return static_cast<float>(255 * linear_to_srgb(std::clamp(v, 0.0, 1.0))); }
  bool linear_ = false;
};

}  // namespace verisim::compare
