// Pixels that take 4, 8, 16 ... points of a low-discrepancy sequence until the estimated error of the mean is small
// enough (docs/sampling.md).
#pragma once

#include <cmath>

#include "tracer/render/sampling/block_centres.h"
#include "tracer/render/sampling/low_discrepancy.h"

namespace verisim::render {

template <class Sampler>
class StratifiedPixels {
 public:
  StratifiedPixels(const AdaptiveSettings& settings, BlockCentres& centres, Sampler& sample)
      : settings_(settings), centres_(centres), sample_(sample) {}

  static constexpr std::size_t kTogether = 64;  // pixels that take their samples in step

  void clear() { pixels_.clear(); }
  void add(int x, int y) { pixels_.push_back(begin(x, y)); }

  // Sets the means of all. The centres around them are known.
  void work() {
    for (bool all_settled = false; !all_settled;) {
      places_.clear();
      for (const Pixel& pixel : pixels_) {
        for (int n = pixel.n; !pixel.settled && n < goal(pixel); ++n) {
          const Vec2 p = pixel.points(static_cast<std::uint32_t>(n));
          places_.emplace_back(pixel.x + p.x - 0.5, pixel.y + p.y - 0.5);
        }
      }
      sample_points(sample_, places_, colors_);
      all_settled = true;
      for (std::size_t next = 0; Pixel & pixel : pixels_) {
        if (pixel.settled) continue;
        const int count = goal(pixel) - pixel.n;
        take(pixel, colors_.data() + next, places_.data() + next, count);
        next += static_cast<std::size_t>(count);
        all_settled = all_settled && pixel.settled;
      }
    }
    for (const Pixel& pixel : pixels_) {
      BlockCentres::Cell& here = centres_.cell(pixel.x, pixel.y);
      const Float4 part(1 / static_cast<float>(pixel.n + 1));
      here.mean = pixel.from_smooth ? pixel.smooth + pixel.beyond.sum * part : (pixel.plain.sum + here.color) * part;
    }
  }

  // Calls neighbour(x, y) for those that the margin of a pixel shows something of that neither centre does, say a thin
  // line.
  template <class F>
  void follow(F&& neighbour) const {
    static constexpr int kSides[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    for (const Pixel& pixel : pixels_) {
      const Float4 here = centres_.shown(pixel.x, pixel.y);
      for (int side = 0; side < 4; ++side) {
        const int x = pixel.x + kSides[side][0], y = pixel.y + kSides[side][1];
        if (!centres_.inside(x, y)) continue;
        const Float4 there = centres_.shown(x, y);
        const Range& margin = pixel.margins[side];
        if (exceeds(max(min(here, there) - margin.low, margin.high - max(here, there)),
                    kSurprise * settings_.tolerance))
          neighbour(x, y);
      }
    }
  }

 private:
  // Found by measurement over a dozen scenes (bench/sampling); none of them is critical.
  static constexpr float kStratified = 0.7f;  // error of a stratified mean: kStratified * deviation * n^-3/4
  static constexpr float kHalves = 0.2f;      // weight of the difference of both halves of the samples in the estimate
  static constexpr float kUnseen = 0.5f;      // of the variance that n equal samples may hide
  static constexpr float kSurprise = 8;       // tolerances beyond what two centres show
  static constexpr int kFirst = 4;            // samples before the first look

  struct Range {
    Float4 low, high;
    void add(Float4 v) { low = min(low, v), high = max(high, v); }
  };
  struct Moments {
    Float4 sum{0.0f}, squares{0.0f}, half{0.0f};  // `half`: the sum of the first half of the samples
    void add(Float4 v) { sum = sum + v, squares = squares + v * v; }
  };
  struct Pixel {
    int x, y;
    LowDiscrepancy points;
    Range around;           // what the centres here and next to it show
    Range margins[4];       // left, right, top, bottom: what lies along the sides
    Float4 smooth;          // the mean of the surface through the centres
    Moments plain, beyond;  // of the samples; of what is left of them beyond that surface
    int n = 0, half_n = 0;
    bool settled = false, from_smooth = false;
  };

  Pixel begin(int x, int y) const {
    const BlockCentres::Cell& here = centres_.cell(x, y);
    Range around{here.color, here.color};
    Float4 smooth(0.0f);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Float4 c = centres_.near(x + dx, y + dy).color;
        around.add(c);
        smooth = smooth + c * Float4((dx ? 0.125f : 0.75f) * (dy ? 0.125f : 0.75f));
      }
    }
    const Float4 shown = centres_.shown(x, y);
    const Range none{shown, shown};
    return {x, y, LowDiscrepancy(x, y, settings_.seed), around, {none, none, none, none}, smooth, {}, {}};
  }

  // The surface through the centres (bilinear between four) at (u, v) from that of the pixel.
  Float4 surface(const Pixel& pixel, float u, float v) const {
    const int x = pixel.x, y = pixel.y, side_x = u < 0 ? x - 1 : x + 1, side_y = v < 0 ? y - 1 : y + 1;
    const Float4 to_x(std::fabs(u)), to_y(std::fabs(v));
    const auto between = [](Float4 from, Float4 to, Float4 part) { return from + part * (to - from); };
    return between(between(centres_.near(x, y).color, centres_.near(side_x, y).color, to_x),
                   between(centres_.near(x, side_y).color, centres_.near(side_x, side_y).color, to_x), to_y);
  }

  // How many samples there are to be before the next look.
  int goal(const Pixel& pixel) const { return std::min(pixel.n == 0 ? kFirst : 2 * pixel.n, settings_.maximum); }

  void take(Pixel& pixel, const Color* colors, const Vec2* places, int count) const {
    pixel.plain.half = pixel.plain.sum, pixel.beyond.half = pixel.beyond.sum, pixel.half_n = pixel.n;
    for (int i = 0; i < count; ++i) {
      const float x = static_cast<float>(places[i].x - pixel.x), y = static_cast<float>(places[i].y - pixel.y);
      const Float4 color = channels(colors[i]);
      pixel.plain.add(color), pixel.beyond.add(color - surface(pixel, x, y));
      if (std::fabs(x) < 0.25f && std::fabs(y) < 0.25f) continue;
      const Float4 shown = as_shown(color, settings_.encoded);
      if (x <= -0.25f) pixel.margins[0].add(shown);
      if (x >= 0.25f) pixel.margins[1].add(shown);
      if (y <= -0.25f) pixel.margins[2].add(shown);
      if (y >= 0.25f) pixel.margins[3].add(shown);
    }
    pixel.n += count;
    const float n = static_cast<float>(pixel.n);
    const Float4 mean = pixel.plain.sum * Float4(1 / n);
    // Where the surface through the centres explains the samples, their mean is that of the surface and what little is
    // left.
    pixel.from_smooth = sum(pixel.beyond.squares) < sum(pixel.plain.squares - mean * pixel.plain.sum);
    pixel.settled = pixel.n >= settings_.maximum || error(pixel, mean) <= settings_.tolerance;
  }
  static float sum(Float4 v) {
    alignas(16) float lanes[4];
    v.store(lanes);
    return lanes[0] + lanes[1] + lanes[2] + lanes[3];
  }

  // Estimated error of the mean of n samples, as a file shows it. The variance is never taken for less than what
  // Laplace's rule of succession leaves for a part of the pixel that no sample met, when it holds what the neighbours
  // hold: four equal samples prove little beside an edge.
  float error(const Pixel& pixel, Float4 of_samples) const {
    const Moments& m = pixel.from_smooth ? pixel.beyond : pixel.plain;
    const float n = static_cast<float>(pixel.n), half_n = static_cast<float>(pixel.half_n);
    const float unseen = kUnseen * (n + 1) / ((n + 2) * (n + 2));
    const Float4 mean = m.sum * Float4(1 / n), range = pixel.around.high - pixel.around.low;
    const Float4 variance = max(m.squares * Float4(1 / n) - mean * mean, Float4(unseen) * range * range);
    Float4 squared = Float4(kStratified * kStratified / (n * std::sqrt(n))) * variance;
    if (half_n > 0) {
      const Float4 difference = m.half * Float4(1 / half_n) - (m.sum - m.half) * Float4(1 / (n - half_n));
      squared = Float4(1 - kHalves) * squared + Float4(0.25f * kHalves) * difference * difference;
    }
    const Float4 e = sqrt(squared);
    return 0.5f *
           largest(distance(as_shown(of_samples + e, settings_.encoded), as_shown(of_samples - e, settings_.encoded)));
  }

  const AdaptiveSettings settings_;
  BlockCentres& centres_;
  Sampler& sample_;
  std::vector<Pixel> pixels_;
  std::vector<Vec2> places_;
  std::vector<Color> colors_;
};

}  // namespace verisim::render
