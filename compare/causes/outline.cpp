#include "compare/causes/outline.h"

#include <cmath>

namespace verisim::compare {
namespace {

constexpr float kLeastContrast = 12 * 12;  // in code values, squared
constexpr std::size_t kFewPairs = 12;

}  // namespace

Outline::Outline(const Case& c, const Mask& mask, const Pixels& picture) : c_(c) {
  std::size_t count = 0;
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x) {
      const std::size_t i = c.at(x, y);
      if (mask[i]) middle_x_ += x, middle_y_ += y, ++count;
      for (const auto& [u, v] : {std::pair(x + 1, y), std::pair(x, y + 1)}) {
        if (u >= c.width || v >= c.height || !mask[i] == !mask[c.at(u, v)]) continue;
        // A pixel further on each side: those at the border are mixed.
        const int step_x = u - x, step_y = v - y;
        double in_x = x - step_x, in_y = y - step_y, out_x = u + step_x, out_y = v + step_y;
        if (!mask[i]) std::swap(in_x, out_x), std::swap(in_y, out_y);
        const Pixel &in = picture[c.clamped(static_cast<int>(in_x), static_cast<int>(in_y))],
                    &out = picture[c.clamped(static_cast<int>(out_x), static_cast<int>(out_y))];
        if (const float contrast = squared_distance(in, out); contrast > kLeastContrast)
          pairs_.push_back({in_x, in_y, out_x, out_y, in, contrast});
      }
    }
  if (count > 0) middle_x_ /= static_cast<double>(count), middle_y_ /= static_cast<double>(count);
}

double Outline::found_at(const Place& place, const Pixels& picture) const {
  if (pairs_.size() < kFewPairs) return 0;
  const auto at = [&](double x, double y) -> const Pixel& {
    return picture[c_.clamped(static_cast<int>(std::lround(middle_x_ + place.zoom * (x - middle_x_) + place.dx)),
                              static_cast<int>(std::lround(middle_y_ + place.zoom * (y - middle_y_) + place.dy)))];
  };
  std::size_t found = 0;
  for (const Pair& p : pairs_) {
    const Pixel &in = at(p.in_x, p.in_y), &out = at(p.out_x, p.out_y);
    found += squared_distance(in, p.inside) < 0.25f * p.contrast && squared_distance(out, p.inside) > 0.5f * p.contrast;
  }
  return static_cast<double>(found) / static_cast<double>(pairs_.size());
}

Outline::Place Outline::best(int reach, const Pixels& picture) const {
  constexpr double kZooms[] = {1, 0.97, 1.03, 0.94, 1.06, 0.9, 1.1, 0.86, 1.16, 0.82, 1.22, 0.75, 1.33};
  Place best;
  double most = found_at(best, picture);
  const auto attempt = [&](const Place& place) {
    if (const double found = found_at(place, picture); found > most + 1e-9) most = found, best = place;
  };
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) attempt({double(dx), double(dy), 1});
  // Another size hardly goes with another place.
  const int nearby = std::min(reach, 3);
  for (const double zoom : kZooms)
    for (int dy = -nearby; dy <= nearby; ++dy)
      for (int dx = -nearby; dx <= nearby; ++dx) attempt({double(dx), double(dy), zoom});
  return best;
}

}  // namespace verisim::compare
