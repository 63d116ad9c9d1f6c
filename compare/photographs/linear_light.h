// Samples of a picture in linear light.
#pragma once

#include <algorithm>
#include <optional>

#include "compare/metrics/values.h"

namespace verisim::compare {

// Floats are linear already, other samples are sRGB.
inline double linear_of(float v, bool is_float) {
  return is_float ? v : srgb_to_linear(std::clamp(static_cast<double>(v), 0.0, 1.0));
}
inline float sample_of(double v, bool is_float) {
  return static_cast<float>(is_float ? v : linear_to_srgb(std::clamp(v, 0.0, 1.0)));
}

// Of a pixel, by its number in the picture; empty when it is clipped or not finite.
inline std::optional<Rgb> linear_color(const Picture& p, std::size_t pixel) {
  constexpr float kClipped = 254.5f / 255;
  Rgb out;
  const std::size_t step = p.channels > 2 ? 1 : 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const float v = p.samples[pixel * static_cast<std::size_t>(p.channels) + c * step];
    if (!std::isfinite(v) || (!p.is_float && (v > kClipped || v < 0))) return std::nullopt;
    out[c] = linear_of(v, p.is_float);
  }
  return out;
}
inline std::optional<Rgb> linear_color(const Picture& p, int x, int y) {
  return linear_color(p, static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) + static_cast<std::size_t>(x));
}

}  // namespace verisim::compare
