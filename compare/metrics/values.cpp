#include "compare/metrics/values.h"

#include <fmt/format.h>

#include <algorithm>

namespace verisim::compare {

Values::Values(const Picture& picture, int first_row, int height)
    : picture_(picture), first_row_(first_row), height_(height) {
  if (picture.width < 1 || picture.height < 1 || picture.channels < 1 || picture.channels > 4 ||
      picture.samples.size() != static_cast<std::size_t>(picture.width) * picture.height * picture.channels)
    throw PictureMismatch(fmt::format("not a picture: {}x{} with {} channels and {} samples", picture.width,
                                      picture.height, picture.channels, picture.samples.size()));
  if (!picture.is_float) return;
  encoded_.reserve(picture.samples.size());
  for (float v : picture.samples) encoded_.push_back(std::isfinite(v) ? static_cast<float>(code_value(v)) : 0.0f);
}

Rgb Values::linear_float(int x, int y) const {
  const std::size_t i = index(x, y);
  const int step = picture_.channels > 2 ? 1 : 0;
  Rgb out;
  for (int c = 0; c < 3; ++c) {
    const float v = picture_.samples[i + c * step];
    out[c] = std::isfinite(v) ? v : 0;
  }
  return out;
}

void require_same_size(const Picture& a, const Picture& b) {
  if (a.width != b.width || a.height != b.height)
    throw PictureMismatch(
        fmt::format("the pictures differ in size: {}x{} and {}x{}", a.width, a.height, b.width, b.height));
}

}  // namespace verisim::compare
