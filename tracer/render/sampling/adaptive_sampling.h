// `--sampler adaptive`: few samples where the picture is smooth, an edge's place where there is one edge,
// low-discrepancy samples where there is more, until the estimated error of a pixel is small enough (docs/sampling.md).
//
// A sampler is any callable Color(double x, double y); pixel centres have integer coordinates. Blocks are independent
// of each other.
#pragma once

#include <array>
#include <vector>

#include "tracer/render/sampling/block_centres.h"
#include "tracer/render/sampling/edge_pixels.h"
#include "tracer/render/sampling/stratified_pixels.h"

namespace verisim::render {

template <class Sampler>
class AdaptiveSampling {
 public:
  AdaptiveSampling(const AdaptiveSettings& settings, int width, int height, Sampler& sample)
      : settings_(settings),
        sample_(sample),
        centres_(settings, width, height),
        edges_(settings, centres_, sample),
        stratified_(settings, centres_, sample) {}

  void render(const Block& block, const BlockPixels& out) {
    block_ = block;
    centres_.trace(block, sample_);
    edges_.clear(), chosen_.clear();
    for_all([&](int x, int y) {
      const Float4 uneven = centres_.uneven(x, y);
      if (exceeds(uneven, kSeen * settings_.tolerance))
        edges_.add(x, y);
      else if (exceeds(uneven, kFaint * settings_.tolerance))
        smooth(x, y);
    });
    edges_.work([&](int x, int y) {
      if (exceeds(centres_.uneven(x, y), kUneven * settings_.tolerance))
        choose(x, y);
      else
        smooth(x, y);
    });
    for (std::size_t first = 0; first < chosen_.size();) {  // grows while it is worked on
      const std::size_t end = std::min(first + StratifiedPixels<Sampler>::kTogether, chosen_.size());
      trace_around(first, end);
      stratified_.clear();
      for (; first < end; ++first) stratified_.add(chosen_[first][0], chosen_[first][1]);
      stratified_.work();
      stratified_.follow([&](int x, int y) { choose(x, y); });
    }
    for_all([&](int x, int y) { out.at(x, y) = color_of(centres_.cell(x, y).mean); });
  }

 private:
  // Found by measurement over a dozen scenes (bench/sampling); none of them is critical.
  // Tolerances that a pixel may lie off the line between two neighbours:
  static constexpr float kFaint = 1;   // before it is smoothed,
  static constexpr float kSeen = 2;    // before an edge is looked for,
  static constexpr float kUneven = 5;  // before it takes samples of its own, if there is no edge

  template <class F>
  void for_all(F&& f) {
    by_tiles(block_.x, block_.y, block_.x + block_.width, block_.y + block_.height, f);
  }
  bool inside_block(int x, int y) const {
    return x >= block_.x && y >= block_.y && x < block_.x + block_.width && y < block_.y + block_.height;
  }

  void choose(int x, int y) {
    if (!inside_block(x, y)) return;
    BlockCentres::Cell& c = centres_.cell(x, y);
    if (c.chosen) return;
    c.chosen = true;
    chosen_.push_back({x, y});
  }

  // Next to chosen pixels nothing is predicted.
  void trace_around(std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) centres_.want_around(chosen_[i][0], chosen_[i][1]);
    while (!centres_.complete()) {
      centres_.trace_wanted(sample_);
      for (const Vec2& p : centres_.traced()) {
        const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
        if (exceeds(centres_.uneven(x, y), kUneven * settings_.tolerance)) choose(x, y);
      }
    }
  }

  // Detail too faint to be worth samples: what centres show of it is noise in part, which their mean has less of.
  void smooth(int x, int y) {
    Float4 sum(0.0f);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        sum = sum + centres_.near(x + dx, y + dy).color * Float4((dx ? 0.25f : 0.5f) * (dy ? 0.25f : 0.5f));
    centres_.cell(x, y).mean = sum;
  }

  const AdaptiveSettings settings_;
  Sampler& sample_;
  Block block_{};
  BlockCentres centres_;
  EdgePixels<Sampler> edges_;
  StratifiedPixels<Sampler> stratified_;
  std::vector<std::array<int, 2>> chosen_;
};

}  // namespace verisim::render
