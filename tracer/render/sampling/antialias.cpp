#include "tracer/render/sampling/antialias.h"

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

Compared encode_for_comparison(const Color& c, const AntialiasSettings& s) {
  if (s.identity) return {c.r, c.g, c.b, c.t};
  const auto encode = [&s](float v) {
    return std::pow(std::fmax(s.decode_srgb ? image::srgb_decode(v) : v, 0.0f), s.exponent);
  };
  const float r = encode(c.r);
  return {r, c.g == c.r ? r : encode(c.g), c.b == c.r ? r : encode(c.b), c.t};
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
