#include "tracer/render/sampling/antialias.h"

#include <bit>

#include "tracer/image/gamma.h"
#include "tracer/render/sampling/adaptive_sampling.h"

namespace verisim::render {

AntialiasSettings antialias_settings(const Options& options, scene::Gamma working, double working_gamma) {
  AntialiasSettings s;
  s.method = std::clamp(options.sampling_method, 0, 2);
  s.depth = std::clamp(options.antialias_depth, 1, 9);
  s.threshold = std::clamp(options.antialias_threshold, 0.0f, 1.0f);
  s.jitter = options.jitter ? std::clamp(options.jitter_amount, 0.0, 1.0) : 0;
  if (options.antialias_gamma > 0) {
    const double power = working == scene::Gamma::power ? working_gamma : 1;
    const double exponent = power / options.antialias_gamma;
    s.decode_srgb = working == scene::Gamma::srgb;
    s.identity = !s.decode_srgb && std::fabs(exponent - 1) <= 0.01;
    s.exponent = static_cast<float>(exponent);
  }
  return s;
}

SampleComparison::SampleComparison(const AntialiasSettings& settings) : settings_(settings) {
  const auto border = [](std::uint32_t i) { return std::bit_cast<float>((kFirst + i) << kShift); };
  float error = 0;  // of a channel
  if (!settings_.identity) {
    for (std::uint32_t i = 0; i <= kCells; ++i) values_[i] = encode(border(i));
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const float middle = 0.5f * (border(i) + border(i + 1));
      error = std::fmax(error, std::fabs(look_up(middle) - encode(middle)));
    }
    // Straight lines are farthest from such curves somewhere near their middle; the rest is for rounding.
    error = 2 * error + 1e-5f;
  }
  certain_ = settings_.threshold + 6 * error;
  certainly_not_ = settings_.threshold - 6 * error;
}

float SampleComparison::encode(float v) const {
  return settings_.identity
             ? v
             : std::pow(std::fmax(settings_.decode_srgb ? image::srgb_decode(v) : v, 0.0f), settings_.exponent);
}

float SampleComparison::look_up(float v) const {
  constexpr std::uint32_t kBelow = (1u << kShift) - 1;
  const auto bits = std::bit_cast<std::uint32_t>(v);
  const std::uint32_t cell = (bits >> kShift) - kFirst;
  if (cell >= kCells) return encode(v);
  const float part = static_cast<float>(bits & kBelow) * (1.0f / (1u << kShift));
  return values_[cell] + part * (values_[cell + 1] - values_[cell]);
}

SampleComparison::Sample SampleComparison::sample(const Color& c) const {
  if (settings_.identity) return {c, c.r, c.g, c.b};
  return {c, look_up(c.r), look_up(c.g), look_up(c.b)};
}

bool SampleComparison::truly_differ(const Color& a, const Color& b) const {
  return std::fabs(encode(a.r) - encode(b.r)) + std::fabs(encode(a.g) - encode(b.g)) +
             std::fabs(encode(a.b) - encode(b.b)) + std::fabs(a.t - b.t) >=
         settings_.threshold;
}

AdaptiveSettings adaptive_settings(const Options& options, scene::Gamma working, double working_gamma) {
  AdaptiveSettings s;
  s.tolerance = std::clamp(options.antialias_threshold, 0.0f, 1.0f) / 20;
  s.maximum = 1 << (2 * std::clamp(options.antialias_depth, 1, 6));
  s.encoded = working == scene::Gamma::srgb || (working == scene::Gamma::power && working_gamma > 1.5) ||
              working == scene::Gamma::none;
  s.seed = options.seed;
  return s;
}

}  // namespace verisim::render
