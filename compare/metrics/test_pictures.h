// Pictures for the tests of this folder and its neighbours.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "compare/metrics/metrics.h"

namespace verisim::compare {

// Values 0..255 by a function of x, y and channel.
inline Picture picture_of(int width, int height, const std::function<double(int, int, int)>& value, int channels = 3) {
  Picture p;
  p.width = width, p.height = height, p.channels = channels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) p.samples.push_back(static_cast<float>(value(x, y, c) / 255));
  return p;
}

inline Picture constant_picture(int width, int height, double r, double g, double b) {
  return picture_of(width, height, [=](int, int, int c) { return c == 0 ? r : c == 1 ? g : b; });
}

inline Picture random_picture(int width, int height, unsigned seed, int channels = 3) {
  std::mt19937 random(seed);
  return picture_of(
      width, height, [&](int, int, int) { return static_cast<double>(random() % 256); }, channels);
}

// Smooth shading with a few sharp edges: what renders look like.
inline Picture scene_like_picture(int width, int height) {
  return picture_of(width, height, [=](int x, int y, int c) {
    const double u = (x + 0.5) / width, v = (y + 0.5) / height;
    const bool disc = std::hypot(u - 0.4, v - 0.5) < 0.25, stripe = std::fmod(8 * u + 3 * v, 1.0) < 0.3;
    return std::round(disc ? 60 + 150 * v + 20 * c : stripe ? 200 - 40 * c : 40 + 80 * u + 15 * c);
  });
}

inline Picture changed(Picture p, const std::function<double(double)>& f) {
  for (float& v : p.samples) v = static_cast<float>(f(255.0 * v) / 255);
  return p;
}

}  // namespace verisim::compare
