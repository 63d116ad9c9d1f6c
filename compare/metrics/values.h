// A picture seen in 8-bit units: what every metric reads.
#pragma once

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

  // 0..255 for integer pictures; floats are clipped and sRGB encoded. A pixel that is not finite reads as black.
  Rgb rgb(int x, int y) const {
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
  std::vector<float> encoded_;  // of a float picture
};

// Throws PictureMismatch naming both sizes.
void require_same_size(const Picture& a, const Picture& b);

// sRGB transfer function, 0..1 (IEC 61966-2-1).
inline double srgb_to_linear(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }
inline double linear_to_srgb(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

}  // namespace verisim::compare
