#include "compare/verdict/limits.h"

#include <fmt/format.h>

#include "compare/metrics/values.h"

namespace verisim::compare {
namespace {

Rgb linear(const Values& values, int x, int y) {
  if (values.is_float()) return values.linear_float(x, y);
  Rgb out = values.rgb(x, y);
  for (double& v : out) v = srgb_to_linear(v / 255);
  return out;
}

}  // namespace

std::uint64_t pixels_beyond(const PixelLimits& limits, const Picture& reference, const Picture& test) {
  require_same_size(reference, test);
  const Values a(reference), b(test);
  std::uint64_t count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      bool wrong = !a.finite(x, y) || !b.finite(x, y);
      const Rgb apart = difference(a, b, x, y), p = linear(a, x, y), q = linear(b, x, y);
      for (std::size_t c = 0; c < 3; ++c)
        wrong = wrong ||
                (std::fabs(apart[c]) > limits.absolute && std::fabs(q[c] - p[c]) > limits.relative * std::fabs(p[c]));
      count += wrong;
    }
  return count;
}

std::string broken_limit(const Limits& limits, const Metrics& metrics, const Picture& reference, const Picture& test) {
  if (const Verdict verdict = judge_thresholds(metrics, limits.figures);
      !limits.figures.empty() && verdict.status == Status::differ)
    return verdict.reason;
  if (!limits.pixels) return "";
  const std::uint64_t beyond = pixels_beyond(*limits.pixels, reference, test);
  return beyond > limits.pixels->pixels ? fmt::format("pixels_beyond {} > {}", beyond, limits.pixels->pixels) : "";
}

}  // namespace verisim::compare
