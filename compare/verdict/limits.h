// Limits that a scene's author sets in the place of the rules: on figures, or on every pixel by itself.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "compare/metrics/metrics.h"
#include "compare/verdict/verdict.h"

namespace verisim::compare {

// A pixel is wrong when a channel differs by more than both; so many of them may be, by any amount.
struct PixelLimits {
  double absolute = 0;  // code values
  double relative = 0;  // of the reference's linear value: 0.01 is 1 %
  std::uint64_t pixels = 0;
};

struct Limits {
  Thresholds figures;
  std::optional<PixelLimits> pixels;
  bool empty() const { return figures.empty() && !pixels; }
};

// Throws PictureMismatch.
std::uint64_t pixels_beyond(const PixelLimits& limits, const Picture& reference, const Picture& test);

// The figure that breaks its limit, as "pixels_beyond 31 > 10"; empty when all are kept.
std::string broken_limit(const Limits& limits, const Metrics& metrics, const Picture& reference, const Picture& test);

}  // namespace verisim::compare
