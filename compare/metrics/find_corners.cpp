// The render is looked for in a small copy of the photograph as a template of many sizes and shapes, by normalised
// cross-correlation, which no exposure disturbs. The best few places are refined to quadrilaterals, first on small
// pictures, whose details reach far, and what fits best then is the place.
#include "compare/metrics/find_corners.h"

#include <algorithm>

#include "compare/metrics/photograph.h"
#include "compare/metrics/values.h"

namespace verisim::compare {
namespace {

constexpr int kSmall = 72;                // the longer side of the photograph that is searched
constexpr double kLeastSimilarity = 0.7;  // of two pictures of the same thing

// Luma, centred and of unit length over a rectangle: the correlation of two is their product.
struct Grey {
  int width = 0, height = 0;
  std::vector<double> luma;
  explicit Grey(const Picture& picture) : width(picture.width), height(picture.height) {
    const Values values(picture);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) luma.push_back(values.luma(x, y));
  }
  double at(int x, int y) const {
    return luma[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

// Pearson's correlation of the template and the part of the picture at x, y.
double correlation(const Grey& picture, const Grey& part, int x0, int y0) {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x) {
      const double p = picture.at(x0 + x, y0 + y), q = part.at(x, y);
      a += p, b += q, aa += p * p, bb += q * q, ab += p * q;
    }
  const double n = static_cast<double>(part.luma.size()), spread = (aa - a * a / n) * (bb - b * b / n);
  return spread > 1e-9 ? (ab - a * b / n) / std::sqrt(spread) : 0;
}

struct Place {
  double x = 0, y = 0, width = 0, height = 0, similarity = 0;
  Corners corners() const { return {{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}}; }
  bool near(const Place& other) const {
    const double room = 0.2 * std::max(width, other.width);
    return std::fabs(x - other.x) < room && std::fabs(y - other.y) < room && std::fabs(width - other.width) < room;
  }
};

Picture small_copy(const Picture& picture, double longer) {
  const double scale = std::min(1.0, longer / std::max(picture.width, picture.height));
  return resampled(picture, std::max(1, static_cast<int>(std::lround(scale * picture.width))),
                   std::max(1, static_cast<int>(std::lround(scale * picture.height))));
}

// The best place of a template of this size.
Place best_place(const Grey& photograph, const Picture& render, int width, int height) {
  const Grey part(resampled(render, width, height));
  Place best{0, 0, static_cast<double>(width), static_cast<double>(height), -1};
  for (int y = 0; y + height <= photograph.height; ++y)
    for (int x = 0; x + width <= photograph.width; ++x)
      if (const double c = correlation(photograph, part, x, y); c > best.similarity)
        best.x = x, best.y = y, best.similarity = c;
  return best;
}

// In pixels of the small copy, best first, none like another.
std::vector<Place> places(const Grey& photograph, const Picture& render) {
  constexpr std::size_t kKept = 5;
  constexpr double kShapes[] = {0.8, 1, 1.25};  // a render seen from aside is narrower
  std::vector<Place> all, out;
  for (double size = 1; size > 0.25; size *= 0.93)
    for (const double shape : kShapes) {
      const int width = static_cast<int>(std::lround(size * photograph.width)),
                height = static_cast<int>(std::lround(shape * width * render.height / render.width));
      if (width >= 8 && height >= 6 && height <= photograph.height && width <= render.width && height <= render.height)
        all.push_back(best_place(photograph, render, width, height));
    }
  std::sort(all.begin(), all.end(), [](const Place& a, const Place& b) { return a.similarity > b.similarity; });
  for (const Place& place : all)
    if (out.size() < kKept && std::none_of(out.begin(), out.end(), [&](const Place& p) { return p.near(place); }))
      out.push_back(place);
  return out;
}

double similarity(const Picture& photograph, const Picture& render, const Alignment& found) {
  return correlation(Grey(aligned(photograph, found, render.width, render.height)), Grey(render), 0, 0);
}

Corners scaled(Corners corners, double x, double y) {
  for (ImagePoint& p : corners) p.x *= x, p.y *= y;
  return corners;
}

}  // namespace

Corners find_corners(const Picture& photograph, const Picture& render) {
  const Picture small = small_copy(photograph, kSmall), middle = small_copy(photograph, 3 * kSmall),
                part = small_copy(render, kSmall);
  const double up = static_cast<double>(middle.width) / small.width,
               down = static_cast<double>(middle.height) / small.height;
  Corners best{};
  double most = kLeastSimilarity;
  for (const Place& place : places(Grey(small), part)) {
    try {
      const Alignment rough = align(small, part, place.corners(), false),
                      found = align(middle, part, scaled(rough.corners, up, down), false);
      if (const double s = similarity(middle, part, found); s > most) most = s, best = found.corners;
    } catch (const PictureMismatch&) {  // refined to no quadrilateral
    }
  }
  if (most == kLeastSimilarity)
    throw PictureMismatch("the photograph seems to show the picture nowhere: give its corners");
  return scaled(best, static_cast<double>(photograph.width) / middle.width,
                static_cast<double>(photograph.height) / middle.height);
}

}  // namespace verisim::compare
