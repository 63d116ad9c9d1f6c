// What happens between neighbouring pixels.
#include <fmt/format.h>

#include "compare/causes/families.h"
#include "compare/causes/registration.h"

namespace verisim::compare {
namespace {

// test = reference + s (blurred reference - reference): s above 0 blurs, below it sharpens.
void blur(const Case& c, Suspicions& out) {
  for (const double sigma : {0.7, 1.4, 3.0}) {
    const Pixels soft = blurred(c, c.reference, sigma);
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < c.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = soft[i][k] - c.reference[i][k];
        xx += x * x, xy += x * (c.test[i][k] - c.reference[i][k]);
      }
    const auto s = static_cast<float>(xx > 0 ? xy / xx : 0);
    if (std::fabs(s) > 2) continue;
    out.push_back(c.repaired(
        s > 0 ? "blur" : "sharpening",
        s > 0
            ? fmt::format("the picture is blurred, {:.0f} % with a radius of {:.1f} pixels", 100 * s, sigma * c.reduced)
            : fmt::format("edges are {:.0f} % steeper, with a radius of {:.1f} pixels", -100 * s, sigma * c.reduced),
        [&](std::size_t i) {
          Pixel p;
          for (std::size_t k = 0; k < 3; ++k) p[k] = c.reference[i][k] + s * (soft[i][k] - c.reference[i][k]);
          return p;
        },
        weight::kRepaired));
  }
}

// Differences that know nothing of each other: the mean of nine of them has a ninth of the square.
void noise(const Case& c, Suspicions& out) {
  constexpr double kWhite = 1.0 / 9, kLeastPart = 0.3;
  if (static_cast<double>(c.wrong_count) < kLeastPart * static_cast<double>(c.size())) return;
  double squares = 0, of_means = 0, mean = 0;
  for (int y = 1; y + 1 < c.height; ++y)
    for (int x = 1; x + 1 < c.width; ++x)
      for (std::size_t k = 0; k < 3; ++k) {
        float sum = 0;
        for (int j = -1; j <= 1; ++j)
          for (int i = -1; i <= 1; ++i) sum += c.test[c.at(x + i, y + j)][k] - c.reference[c.at(x + i, y + j)][k];
        const double d = c.test[c.at(x, y)][k] - c.reference[c.at(x, y)][k];
        squares += d * d, of_means += sum * sum / 81, mean += d;
      }
  if (squares <= 0) return;
  const double white = std::clamp((1 - of_means / squares) / (1 - kWhite), 0.0, 1.0);
  if (white < 0.5) return;
  Suspicion s = c.placed("noise",
                         fmt::format("differences of {:.2f} code values that know nothing of their neighbours",
                                     std::sqrt(squares / (3.0 * static_cast<double>(c.size())))),
                         c.wrong, 1);
  s.explained = white,
  s.sure = 0.8 * white * white * static_cast<double>(c.wrong_count) / static_cast<double>(c.size());
  out.push_back(std::move(s));
}

// Squares of one colour.
void pixelation(const Case& c, Suspicions& out) {
  for (const int side : {2, 3, 4, 5, 6, 8, 10, 12, 16}) {
    // Neighbours of different colours: within squares there are none, on their borders there are.
    std::size_t within = 0, across = 0, usual = 0;
    for (int y = 0; y < c.height; ++y)
      for (int x = 1; x < c.width; ++x) {
        const std::size_t i = c.at(x, y), before = c.at(x - 1, y);
        const bool other = squared_distance(c.test[i], c.test[before]) >= 0.02f;
        if (x % side == 0)
          across += other;
        else
          within += other, usual += squared_distance(c.reference[i], c.reference[before]) > 1;
      }
    if (across == 0 || within * 50 > across || usual == 0) continue;
    out.push_back(c.repaired(
        "pixelation", fmt::format("squares of {0} x {0} pixels have one colour", side * c.reduced),
        [&](std::size_t i) {
          const int x = static_cast<int>(i % static_cast<std::size_t>(c.width)),
                    y = static_cast<int>(i / static_cast<std::size_t>(c.width));
          return c.test[c.at(x / side * side, y / side * side)];
        },
        weight::kRepaired));
  }
}

// Values that lie between those of the neighbours in the other picture, and are none of them: one side averages over
// the pixel, the other does not.
void anti_aliasing(const Case& c, Suspicions& out) {
  constexpr double kSmooth = 0.75;  // less than a blur that explains it all
  for (const bool test_is_smooth : {true, false}) {
    const Pixels &sharp = test_is_smooth ? c.reference : c.test, &smooth = test_is_smooth ? c.test : c.reference;
    Mask between(c.size());
    std::size_t extreme = 0, count = 0;
    for (int y = 0; y < c.height; ++y)
      for (int x = 0; x < c.width; ++x) {
        const std::size_t i = c.at(x, y);
        if (!c.wrong[i] || c.squared[i] < 4) continue;
        bool is_neighbour = false, inside = true;
        for (std::size_t k = 0; k < 3; ++k) {
          float low = 255, high = 0;
          for (int v = -1; v <= 1; ++v)
            for (int u = -1; u <= 1; ++u)
              low = std::min(low, sharp[c.clamped(x + u, y + v)][k]),
              high = std::max(high, sharp[c.clamped(x + u, y + v)][k]);
          inside = inside && smooth[i][k] >= low - 2 && smooth[i][k] <= high + 2;
        }
        for (int v = -1; v <= 1; ++v)
          for (int u = -1; u <= 1; ++u)
            is_neighbour = is_neighbour || squared_distance(sharp[c.clamped(x + u, y + v)], smooth[i]) < 12;
        between[i] = inside && !is_neighbour;
        count += between[i], extreme += inside && is_neighbour;
      }
    if (count < 10 || count < 2 * extreme) continue;
    out.push_back(c.placed(
        "anti-aliasing",
        test_is_smooth ? "edges are smooth, and hard in the reference" : "edges are hard, and smooth in the reference",
        between, kSmooth));
  }
}

}  // namespace

void suspect_filtering(const Case& c, Suspicions& out) {
  if (c.reduced == 1) pixelation(c, out), anti_aliasing(c, out);
  blur(c, out), noise(c, out);
}

}  // namespace verisim::compare
