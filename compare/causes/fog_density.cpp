#include "compare/causes/fog_density.h"

#include <algorithm>
#include <cmath>

namespace verisim::compare {
namespace {

Pixel color_of(const Pixels& fog) {
  Pixel out{};
  if (fog.empty()) return out;
  std::vector<float> values(fog.size());
  const auto nearly_last = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 199 / 200);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < fog.size(); ++i) values[i] = fog[i][k];
    std::nth_element(values.begin(), nearly_last, values.end());
    out[k] = *nearly_last;
  }
  return out;
}

Pixel change_of(const Pixel& all, const Pixel& fog, const Pixel& color, double density) {
  constexpr double kOpaque = 1e-3;  // what is behind is not known
  Pixel out{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(color[k] > 0)) continue;
    const double passed = 1 - std::min(fog[k] / color[k], 1.0f), other = std::pow(passed, density);
    const double behind = passed > kOpaque ? (all[k] - fog[k]) / passed : 0;
    out[k] = static_cast<float>((behind - color[k]) * (other - passed));
  }
  return out;
}

}  // namespace

std::optional<OtherFog> other_fog(const Pixels& all, const Pixels& fog, const Pixels& more, const Mask& judged) {
  constexpr double kFirstStep = 0.25, kLastStep = 1e-3, kHardly = 0.02, kMax = 3;  // of the density's logarithm
  constexpr std::size_t kEvery = 3;                                                // pixels
  const Pixel color = color_of(fog);
  const auto left = [&](double density) {
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); i += kEvery)
      if (judged[i]) sum += squared_distance(change_of(all[i], fog[i], color, density), more[i]);
    return sum;
  };
  double best = 0, least = left(1);
  for (double step = kFirstStep; step > kLastStep; step /= 2)
    for (const double way : {-step, step})
      while (std::fabs(best + way) < kMax) {
        const double next = left(std::exp(best + way));
        if (!(next < least)) break;
        least = next, best += way;
      }
  if (std::fabs(best) < kHardly) return std::nullopt;
  OtherFog out{std::exp(best), Pixels(all.size())};
  for (std::size_t i = 0; i < all.size(); ++i) out.change[i] = change_of(all[i], fog[i], color, out.density);
  return out;
}

}  // namespace verisim::compare
