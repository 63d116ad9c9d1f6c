// A picture seen in 8-bit units: what every metric reads.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "compare/metrics/metrics.h"

namespace verisim::compare {

using Rgb = std::array<double, 3>;

class Values {
 public:
  // Keeps a reference. Throws PictureMismatch when the sample count does not fit the size.
  explicit Values(const Picture& picture) : Values(picture, 0, picture.height) {}
  // `rows` holds only some rows, from first_row on, of a picture that is `height` high; no other rows may be asked for.
  Values(const Picture& rows, int first_row, int height);

  int width() const { return picture_.width; }
  int height() const { return height_; }
  bool has_alpha() const { return picture_.channels == 2 || picture_.channels == 4; }

  bool is_float() const { return picture_.is_float; }
  int bits() const { return picture_.is_float ? 32 : picture_.bits; }

  // As a screen shows it, 0..255: floats are clipped and sRGB encoded. A pixel that is not finite reads as black.
  Rgb rgb(int x, int y) const {
    Rgb out = code(x, y);
    if (is_float())
      for (double& v : out) v = std::clamp(v, 0.0, 255.0);
    return out;
  }
  // The same, but floats go on above white and below black (code_value).
  Rgb code(int x, int y) const {
    const std::size_t i = index(x, y);
    const int step = picture_.channels > 2 ? 1 : 0;
    return {value(i), value(i + step), value(i + 2 * step)};
  }
  double alpha(int x, int y) const {
    if (!has_alpha()) return 255;
    const double a = 255.0 * picture_.samples[index(x, y) + picture_.channels - 1];
    return !std::isfinite(a) ? 0 : picture_.bits == 8 && !picture_.is_float ? std::round(a) : a;
  }
  bool finite(int x, int y) const {
    const std::size_t i = index(x, y);
    for (int c = 0; c < picture_.channels; ++c)
      if (!std::isfinite(picture_.samples[i + c])) return false;
    return true;
  }
  // Rec. 601 luma, 0..255.
  double luma(int x, int y) const {
    const Rgb v = rgb(x, y);
    return 0.299 * v[0] + 0.587 * v[1] + 0.114 * v[2];
  }
  // The values of a float picture as they are; not finite ones are 0.
  Rgb linear_float(int x, int y) const;

 private:
  std::size_t index(int x, int y) const {
    return (static_cast<std::size_t>(y - first_row_) * picture_.width + x) * picture_.channels;
  }
  double value(std::size_t i) const {
    if (!encoded_.empty()) return encoded_[i];
    const double v = 255.0 * picture_.samples[i];
    return picture_.bits == 8 ? std::round(v) : v;
  }

  const Picture& picture_;
  int first_row_, height_;
  std::vector<float> encoded_;  // code values of a float picture
};

// Code values to judge two pictures by: floats are clipped only where the other picture cannot hold them.
inline Rgb judged(const Values& picture, const Values& other, int x, int y) {
  return picture.is_float() && other.is_float() ? picture.code(x, y) : picture.rgb(x, y);
}
inline Rgb difference(const Values& reference, const Values& test, int x, int y) {
  const Rgb p = judged(reference, test, x, y), q = judged(test, reference, x, y);
  return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
}

// Throws PictureMismatch naming both sizes.
void require_same_size(const Picture& a, const Picture& b);

// sRGB transfer function, 0..1 (IEC 61966-2-1).
inline double srgb_to_linear(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }
inline double linear_to_srgb(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

// A linear value of any size in 8-bit units: the sRGB curve from black to white; above white its logarithm, with the
// slope that the curve has at white, so that a unit is 0.9 % of the value there and everywhere above; below black the
// mirror image.
inline double code_value(double v) {
  constexpr double kSlopeAtWhite = 1.055 / 2.4;
  const double size = std::fabs(v);
  return std::copysign(255 * (size <= 1 ? linear_to_srgb(size) : 1 + kSlopeAtWhite * std::log(size)), v);
}

}  // namespace verisim::compare
