#include "cli/rays/viewpoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace verisim::cli {

Vec2 Viewpoint::project(const Vec3& p, int pixels) const {
  const double scale = pixels / width;
  const Vec3 d = p - center;
  return {(dot(d, right) + width / 2) * scale, (height / 2 - dot(d, up)) * scale};
}

Viewpoint viewpoint_of(const std::vector<Vec3>& points, double azimuth, double elevation, int width, int height) {
  constexpr double kMargin = 1.25, kLeast = 1e-6, kDegree = std::numbers::pi / 180;
  const double a = azimuth * kDegree, e = elevation * kDegree;
  Viewpoint view;
  view.forward = {std::cos(e) * std::sin(a), -std::sin(e), std::cos(e) * std::cos(a)};
  view.right = {std::cos(a), 0, -std::sin(a)};
  view.up = cross(view.forward, view.right);
  const Vec3* axes[] = {&view.right, &view.up, &view.forward};
  double low[3], high[3];
  for (int k = 0; k < 3; ++k) {
    low[k] = points.empty() ? 0 : std::numeric_limits<double>::infinity(), high[k] = -low[k];
    for (const Vec3& p : points)
      low[k] = std::min(low[k], dot(p, *axes[k])), high[k] = std::max(high[k], dot(p, *axes[k]));
    view.center += *axes[k] * ((low[k] + high[k]) / 2);
  }
  const double shape = static_cast<double>(width) / height;
  view.width = std::max({high[0] - low[0], (high[1] - low[1]) * shape, kLeast}) * kMargin;
  view.height = view.width / shape;
  view.near = (low[2] - high[2]) / 2 - 0.02 * view.width;
  return view;
}

}  // namespace verisim::cli
