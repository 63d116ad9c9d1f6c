// Parts of the picture with straight borders: tiles that were lost, are elsewhere or too dark; rows; the corners.
#include <fmt/format.h>

#include <limits>

#include "compare/causes/families.h"

namespace verisim::compare {
namespace {

struct Rectangle {
  int x0, y0, x1, y1;  // the last ones are outside
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  double area() const { return static_cast<double>(width()) * height(); }
  bool holds(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
};

std::optional<Rectangle> around(const Case& c, const Mask& mask) {
  Rectangle r{c.width, c.height, 0, 0};
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x)
      if (mask[c.at(x, y)]) r = {std::min(r.x0, x), std::min(r.y0, y), std::max(r.x1, x + 1), std::max(r.y1, y + 1)};
  return r.x1 > r.x0 ? std::optional(r) : std::nullopt;
}

// The largest set of wrong pixels that touch each other, by the squared difference.
Mask largest_cluster(const Case& c) {
  Mask seen(c.size()), best;
  double most = 0;
  for (std::size_t start = 0; start < c.size(); ++start) {
    if (!c.wrong[start] || seen[start]) continue;
    std::vector<std::size_t> members{start};
    seen[start] = 1;
    double sum = 0;
    for (std::size_t n = 0; n < members.size(); ++n) {
      const int x = static_cast<int>(members[n] % static_cast<std::size_t>(c.width)),
                y = static_cast<int>(members[n] / static_cast<std::size_t>(c.width));
      sum += c.squared[members[n]];
      for (int j = std::max(0, y - 1); j <= std::min(c.height - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(c.width - 1, x + 1); ++i)
          if (const std::size_t k = c.at(i, j); c.wrong[k] && !seen[k]) seen[k] = 1, members.push_back(k);
    }
    if (sum <= most) continue;
    most = sum, best.assign(c.size(), 0);
    for (std::size_t m : members) best[m] = 1;
  }
  return best;
}

Mask mask_of(const Case& c, const Rectangle& r) {
  Mask out(c.size());
  for (int y = r.y0; y < r.y1; ++y)
    for (int x = r.x0; x < r.x1; ++x) out[c.at(x, y)] = 1;
  return out;
}

std::string place(const Case& c, const Rectangle& r) {
  return fmt::format("columns {} to {}, rows {} to {}", r.x0 * c.reduced, r.x1 * c.reduced - 1, r.y0 * c.reduced,
                     r.y1 * c.reduced - 1);
}

// The part of the rectangle's border, as far as it lies within the picture, at which it cuts through an object: wrong
// inside and right outside, and the same thing is seen on both sides. What borders on other things may end there for
// their sake. 1 where nobody knows what is seen.
double cut(const Case& c, const Rectangle& r) {
  const PixelTags* tags = c.tags.any();
  if (!tags) return 1;
  std::size_t all = 0, cuts = 0;
  const auto look = [&](int x, int y, int outer_x, int outer_y) {
    if (outer_x < 0 || outer_y < 0 || outer_x >= c.width || outer_y >= c.height) return;
    const std::size_t i = c.at(x, y), o = c.at(outer_x, outer_y);
    ++all, cuts += c.wrong[i] && !c.wrong[o] && c.set_of(*tags, i) == c.set_of(*tags, o);
  };
  for (int x = r.x0; x < r.x1; ++x) look(x, r.y0, x, r.y0 - 1), look(x, r.y1 - 1, x, r.y1);
  for (int y = r.y0; y < r.y1; ++y) look(r.x0, y, r.x0 - 1, y), look(r.x1 - 1, y, r.x1, y);
  return all > 0 ? static_cast<double>(cuts) / static_cast<double>(all) : 0;
}

// What is wrong inside: lost, shifted, too dark.
void inside(const Case& c, const Rectangle& r, Suspicions& out) {
  const Mask mask = mask_of(c, r);
  const bool rows = 2 * r.width() > c.width && r.height() <= 3, columns = 2 * r.height() > c.height && r.width() <= 3;
  double spread = 0;
  Pixel first = c.test[c.at(r.x0, r.y0)];
  for (std::size_t i = 0; i < c.size(); ++i)
    if (mask[i]) spread = std::max<double>(spread, squared_distance(c.test[i], first));
  const std::string one_color =
      spread < 1 ? fmt::format(", all {:.0f} {:.0f} {:.0f}", first[0], first[1], first[2]) : "";
  Suspicion s = c.placed(rows ? "rows" : columns ? "columns" : "rectangle", place(c, r) + one_color, mask, 1);
  // Pixels that happen to have the lost tile's colour are right; an object is no full rectangle.
  const bool fills = s.precision > 0.85 || (spread < 1 && s.precision > 0.6);
  const double cutting = std::max(0.0, 2 * cut(c, r) - 1);
  s.sure = weight::kRepaired * s.explained * (fills ? 1 : 0.4 * s.precision) * cutting;
  out.push_back(std::move(s));

  if (spread < 1) return;  // what is of one colour may come from anywhere
  const int far =
      std::min({24, std::max(c.width, c.height) / 4, static_cast<int>(3e7 / std::max(1.0, r.area() * 49 * 49) * 24)});
  double best = std::numeric_limits<double>::max(), still = 0;
  int bx = 0, by = 0;
  for (int v = -far; v <= far; ++v)
    for (int u = -far; u <= far; ++u) {
      double sum = 0;
      for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x)
          sum += squared_distance(c.reference[c.clamped(x - u, y - v)], c.test[c.at(x, y)]);
      if (u == 0 && v == 0) still = sum;
      if (sum < best) best = sum, bx = u, by = v;
    }
  if ((bx || by) && best < 0.3 * still)
    out.push_back(c.repaired(
        "part shifted",
        fmt::format("{}: moved by {}, {} pixels (right, down)", place(c, r), bx * c.reduced, by * c.reduced),
        [&](std::size_t i) {
          const int x = static_cast<int>(i % static_cast<std::size_t>(c.width)),
                    y = static_cast<int>(i / static_cast<std::size_t>(c.width));
          return c.reference[c.clamped(x - bx, y - by)];
        },
        cutting, &mask));
}

// Darker with the square of the distance from the middle, in stored values and in linear light.
void vignetting(const Case& c, Suspicions& out) {
  for (const bool linear : {false, true}) {
    const auto in = [&](float v) { return linear ? srgb_to_linear(v / 255) : v / 255; };
    const auto back = [&](double v) {
      return static_cast<float>(255 * (linear ? linear_to_srgb(std::clamp(v, 0.0, 1.0)) : v));
    };
    const auto radius = [&](std::size_t i) {
      const double x = 2.0 * static_cast<double>(i % static_cast<std::size_t>(c.width)) / c.width - 1,
                   y = 2.0 * static_cast<double>(i / static_cast<std::size_t>(c.width)) / c.height - 1;
      return (x * x + y * y) / 2;
    };
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < c.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const double p = in(c.reference[i][k]), x = p * radius(i);
        xx += x * x, xy += x * (in(c.test[i][k]) - p);
      }
    const double s = xx > 0 ? xy / xx : 0;
    if (std::fabs(s) > 1) continue;  // corners that are black or doubled are no lens's
    out.push_back(c.repaired(
        "vignetting", fmt::format("corners are {:.1f} % {}", 100 * std::fabs(s), s < 0 ? "darker" : "brighter"),
        [&](std::size_t i) {
          Pixel p;
          for (std::size_t k = 0; k < 3; ++k) p[k] = back(in(c.reference[i][k]) * (1 + s * radius(i)));
          return p;
        },
        weight::kRepaired));
  }
}

}  // namespace

void suspect_regions(const Case& c, Suspicions& out) {
  vignetting(c, out);
  std::vector<Rectangle> tried;
  for (const Mask& mask : {c.wrong, largest_cluster(c)}) {
    if (mask.empty()) continue;
    const auto r = around(c, mask);
    if (!r || r->area() > 0.75 * static_cast<double>(c.size()) || r->area() < 4) continue;
    if (!tried.empty() && tried[0].area() == r->area()) continue;
    tried.push_back(*r);
    inside(c, *r, out);
  }
}

}  // namespace verisim::compare
