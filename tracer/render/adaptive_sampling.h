// `--sampler adaptive`: low-discrepancy samples where the picture needs them, until the estimated error of a pixel is small enough (docs/sampling.md).
//
// A sampler is any callable Color(double x, double y); pixel centres have integer coordinates. Blocks are independent of each other.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "tracer/render/antialias.h"
#include "tracer/render/low_discrepancy.h"

namespace verisim::render {

struct AdaptiveSettings {
  float tolerance = 0.015f;  // accepted error of a pixel, of its worst channel as a file shows it (0..1)
  int maximum = 64;          // samples of one pixel
  bool encoded = false;      // the working space has a gamma already
  std::uint64_t seed = 0;
};
AdaptiveSettings adaptive_settings(const Options& options, scene::Gamma working, double working_gamma);

template <class Sampler>
class AdaptiveSampling {
 public:
  AdaptiveSampling(const AdaptiveSettings& settings, int width, int height, Sampler& sample)
      : settings_(settings), width_(width), height_(height), sample_(sample) {}

  void render(const Block& block, Framebuffer& out) {
    trace_centres(block);
    chosen_.clear();
    for (int y = block.y; y < block.y + block.height; ++y)
      for (int x = block.x; x < block.x + block.width; ++x)
        if (uneven(x, y)) choose(x, y);
    for (std::size_t first = 0; first < chosen_.size();) {  // grows while it is worked on
      const std::size_t count = std::min(chosen_.size() - first, kTogether);
      refine(first, count);
      for (std::size_t i = 0; i < count; ++i) follow(block, pixels_[i]);
      first += count;
    }
    for (int y = block.y; y < block.y + block.height; ++y)
      for (int x = block.x; x < block.x + block.width; ++x) out.at(x, y) = cell(x, y).mean;
  }

 private:
  // Found by measurement over a dozen scenes (bench/sampling); none of them is critical.
  static constexpr float kUneven = 4;         // tolerances that a pixel may lie off the line between two neighbours
  static constexpr float kStratified = 0.7f;  // error of a stratified mean: kStratified * deviation * n^-3/4
  static constexpr float kHalves = 0.3f;      // weight of the difference of both halves of the samples in the estimate
  static constexpr float kUnseen = 0.5f;      // of the variance that n equal samples may hide
  static constexpr float kSurprise = 8;       // tolerances beyond what two centres show
  static constexpr int kFirst = 4;            // samples before the first look
  static constexpr std::size_t kTogether = 64;  // pixels that take their samples in step

  using Channels = std::array<float, 4>;  // r, g, b, transmit
  struct Cell {
    Color color, mean;  // of the centre, of the pixel
    Channels encoded;   // of the centre
    bool traced = false, chosen = false;
  };
  struct Range {
    Channels low, high;
    void add(const Channels& v) {
      for (std::size_t k = 0; k < v.size(); ++k) low[k] = std::min(low[k], v[k]), high[k] = std::max(high[k], v[k]);
    }
  };
  // A pixel that takes samples.
  struct Pixel {
    int x, y;
    LowDiscrepancy points;
    Range around;                  // what the centres here and next to it show
    std::array<Range, 4> margins;  // left, right, top, bottom: what lies along the sides
    Channels sum{}, squares{}, half{};  // `half`: of the first half_n samples
    Color total{};
    int n = 0, half_n = 0;
    bool settled = false;
  };
  Cell& cell(int x, int y) { return cells_[static_cast<std::size_t>(y - origin_y_) * stride_ + (x - origin_x_)]; }

  static Channels channels(const Color& c) { return {c.r, c.g, c.b, c.t}; }
  // About as a file shows it: clipped, and the root for sRGB's curve.
  float encode(float v) const {
    v = v > 0 ? std::min(v, 1.0f) : 0.0f;
    return settings_.encoded ? v : std::sqrt(v);
  }
  Channels encode(const Color& c) const { return {encode(c.r), encode(c.g), encode(c.b), c.t}; }

  // The centres of the block's pixels and of those around it.
  void trace_centres(const Block& block) {
    stride_ = block.width + 2, origin_x_ = block.x - 1, origin_y_ = block.y - 1;
    cells_.assign(static_cast<std::size_t>(stride_) * (block.height + 2), {});
    const int left = std::max(origin_x_, 0), right = std::min(block.x + block.width + 1, width_);
    colors_.resize(static_cast<std::size_t>(right - left));
    for (int y = std::max(origin_y_, 0); y < std::min(block.y + block.height + 1, height_); ++y) {
      sample_row(sample_, left, y, right - left, colors_.data());
      for (int x = left; x < right; ++x) {
        Cell& c = cell(x, y);
        c.color = c.mean = colors_[static_cast<std::size_t>(x - left)];
        c.encoded = encode(c.color);
        c.traced = true;
      }
    }
  }

  void choose(int x, int y) {
    Cell& c = cell(x, y);
    if (c.chosen) return;
    c.chosen = true;
    chosen_.push_back({x, y});
  }

  // Does the pixel lie off the line between neighbours on opposite sides? On a ramp its centre is enough.
  bool uneven(int x, int y) {
    static constexpr int kPairs[4][2] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
    const Cell& here = cell(x, y);
    float largest = 0;
    for (const auto& [dx, dy] : kPairs) {
      const Cell &a = cell(x - dx, y - dy), &b = cell(x + dx, y + dy);
      const Channels &before = a.traced ? a.encoded : here.encoded, &after = b.traced ? b.encoded : here.encoded;
      for (std::size_t k = 0; k < here.encoded.size(); ++k) largest = std::max(largest, std::fabs(2 * here.encoded[k] - before[k] - after[k]));
    }
    return largest > kUneven * settings_.tolerance;
  }

  // Does the margin between two pixels hold something that neither centre shows, say a thin line?
  bool goes_on(const Range& margin, const Channels& here, const Channels& there) const {
    const float surprise = kSurprise * settings_.tolerance;
    for (std::size_t k = 0; k < here.size(); ++k)
      if (margin.low[k] < std::min(here[k], there[k]) - surprise || margin.high[k] > std::max(here[k], there[k]) + surprise) return true;
    return false;
  }

  // Neighbours that the margin of a pixel shows something of.
  void follow(const Block& block, const Pixel& pixel) {
    static constexpr int kSides[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    for (std::size_t side = 0; side < 4; ++side) {
      const int x = pixel.x + kSides[side][0], y = pixel.y + kSides[side][1];
      if (x < block.x || y < block.y || x >= block.x + block.width || y >= block.y + block.height) continue;
      if (goes_on(pixel.margins[side], cell(pixel.x, pixel.y).encoded, cell(x, y).encoded)) choose(x, y);
    }
  }

  // Samples of some chosen pixels until the error of each is small enough.
  void refine(std::size_t first, std::size_t count) {
    pixels_.clear();
    for (std::size_t i = first; i < first + count; ++i) pixels_.push_back(begin(chosen_[i][0], chosen_[i][1]));
    for (bool all_settled = false; !all_settled;) {
      places_.clear();
      for (Pixel& pixel : pixels_) {
        for (int n = pixel.n; !pixel.settled && n < goal(pixel); ++n) {
          const Vec2 p = pixel.points(static_cast<std::uint32_t>(n));
          places_.emplace_back(pixel.x + p.x - 0.5, pixel.y + p.y - 0.5);
        }
      }
      sample_points(sample_, places_, colors_);
      all_settled = true;
      for (std::size_t next = 0; Pixel& pixel : pixels_) {
        if (pixel.settled) continue;
        const int count_now = goal(pixel) - pixel.n;
        add(pixel, colors_.data() + next, places_.data() + next, count_now);
        next += static_cast<std::size_t>(count_now);
        all_settled = all_settled && pixel.settled;
      }
    }
    for (const Pixel& pixel : pixels_) {
      Cell& here = cell(pixel.x, pixel.y);
      here.mean = (pixel.total + here.color) * (1.0f / static_cast<float>(pixel.n + 1));
    }
  }

  Pixel begin(int x, int y) {
    const Cell& here = cell(x, y);
    Range around{channels(here.color), channels(here.color)};
    for (int ny = y - 1; ny <= y + 1; ++ny) {
      for (int nx = x - 1; nx <= x + 1; ++nx) {
        if (const Cell& c = cell(nx, ny); c.traced) around.add(channels(c.color));
      }
    }
    const Range none{here.encoded, here.encoded};
    return {x, y, LowDiscrepancy(x, y, settings_.seed), around, {none, none, none, none}};
  }

  // How many samples there are to be before the next look.
  int goal(const Pixel& pixel) const { return std::min(pixel.n == 0 ? kFirst : 2 * pixel.n, settings_.maximum); }

  void add(Pixel& pixel, const Color* colors, const Vec2* places, int count) {
    pixel.half = pixel.sum, pixel.half_n = pixel.n;
    for (int i = 0; i < count; ++i) {
      const Color& c = colors[i];
      pixel.total += c;
      const Channels v = channels(c);
      for (std::size_t k = 0; k < v.size(); ++k) pixel.sum[k] += v[k], pixel.squares[k] += v[k] * v[k];
      const double x = places[i].x - pixel.x, y = places[i].y - pixel.y;
      if (std::fabs(x) < 0.25 && std::fabs(y) < 0.25) continue;
      const Channels e = encode(c);
      if (x <= -0.25) pixel.margins[0].add(e);
      if (x >= 0.25) pixel.margins[1].add(e);
      if (y <= -0.25) pixel.margins[2].add(e);
      if (y >= 0.25) pixel.margins[3].add(e);
    }
    pixel.n += count;
    pixel.settled = pixel.n >= settings_.maximum || error(pixel) <= settings_.tolerance;
  }

  // Estimated error of the mean of n samples, encoded. The variance is never taken for less than what Laplace's rule of succession leaves for a part of the
  // pixel that no sample met, when it holds what the neighbours hold: four equal samples prove little beside an edge.
  float error(const Pixel& pixel) const {
    const Channels &sum = pixel.sum, &squares = pixel.squares, &half = pixel.half;
    const Range& around = pixel.around;
    const int n = pixel.n, half_n = pixel.half_n;
    const float count = static_cast<float>(n), shrink = kStratified * std::pow(count, -0.75f);
    const float unseen = kUnseen * (count + 1) / ((count + 2) * (count + 2));
    float worst = 0;
    for (std::size_t k = 0; k < sum.size(); ++k) {
      const float mean = sum[k] / count, range = around.high[k] - around.low[k];
      const float variance = std::max(squares[k] / count - mean * mean, unseen * range * range);
      float e = shrink * std::sqrt(variance);
      if (half_n > 0) {
        const float difference = half[k] / static_cast<float>(half_n) - (sum[k] - half[k]) / static_cast<float>(n - half_n);
        e = std::sqrt((1 - kHalves) * e * e + kHalves * 0.25f * difference * difference);
      }
      worst = std::max(worst, k == 3 ? e : 0.5f * (encode(mean + e) - encode(mean - e)));
    }
    return worst;
  }

  const AdaptiveSettings settings_;
  const int width_, height_;
  Sampler& sample_;
  int stride_ = 0, origin_x_ = 0, origin_y_ = 0;
  std::vector<Cell> cells_;
  std::vector<std::array<int, 2>> chosen_;
  std::vector<Pixel> pixels_;
  std::vector<Vec2> places_;
  std::vector<Color> colors_;
};

}  // namespace verisim::render
