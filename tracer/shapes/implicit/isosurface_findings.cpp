#include "tracer/shapes/implicit/isosurface_findings.h"

#include <fmt/format.h>

#include "tracer/math/constants.h"

namespace verisim::shapes {

std::string max_gradient_finding(double found, double set) {
  if (!(found > kEpsilon && set > kEpsilon)) return {};
  const double too_much = set - found, ratio = set / found;
  const std::string start = fmt::format(
      "The maximum gradient found was {:.3f}, but max_gradient of the isosurface was set to {:.3f}. ", found, set);
  if ((ratio <= 0.9 && too_much <= -0.5) || ((ratio <= 0.95 || too_much <= -0.1) && set < 10))
    return start + "The isosurface may contain holes! Adjust max_gradient to get a proper rendering of the isosurface.";
  if (too_much >= 10 || (ratio >= 1.1 && too_much >= 0.5))
    return start + "Adjust max_gradient to get a faster rendering of the isosurface.";
  return {};
}

std::string evaluate_finding(const Vec3& evaluate, double largest, double variation, double average) {
  if (!(evaluate.x > largest || evaluate.y > largest / (largest - variation))) return {};
  return fmt::format(
      "Evaluate found a maximum gradient of {:.3f} and an average gradient of {:.3f}. The maximum gradient variation "
      "was {:.3f}.",
      largest, average, variation);
}

}  // namespace verisim::shapes
