// What the parts of `--sampler adaptive` share: its settings, and colours as a file shows them, four channels at a time
// (docs/sampling.md).
#pragma once

#include "tracer/simd/float4.h"
#include "tracer/render/sampling/antialias.h"

namespace verisim::render {

struct AdaptiveSettings {
  float tolerance = 0.015f;  // accepted error of a pixel, of its worst channel as a file shows it (0..1)
  int maximum = 64;          // samples of one pixel
  bool encoded = false;      // the working space has a gamma already
  std::uint64_t seed = 0;
};
AdaptiveSettings adaptive_settings(const Options& options, scene::Gamma working, double working_gamma);

using accel::Float4;

inline Float4 distance(Float4 a, Float4 b) { return max(a - b, b - a); }
inline bool exceeds(Float4 v, float limit) { return (v <= Float4(limit)).bits() != 15; }
inline float largest(Float4 v) {
  alignas(16) float lanes[4];
  v.store(lanes);
  return std::max(std::max(lanes[0], lanes[1]), std::max(lanes[2], lanes[3]));
}
inline Float4 channels(const Color& c) { return {c.r, c.g, c.b, c.t}; }
inline Color color_of(Float4 v) {
  alignas(16) float lanes[4];
  v.store(lanes);
  return {lanes[0], lanes[1], lanes[2], 0, lanes[3]};
}
// About as a file shows it: clipped, and the root for sRGB's curve; transmit stays as it is.
inline Float4 as_shown(Float4 v, bool encoded) {
  const Float4 clipped = min(max(v, Float4(0.0f)), Float4(1.0f));
  if (encoded) return clipped;
  return sqrt(clipped * (Float4(1, 1, 1, 0) + Float4(0, 0, 0, 1) * clipped));
}

}  // namespace verisim::render
