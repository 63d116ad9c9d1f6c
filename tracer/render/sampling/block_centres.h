// The first look of `--sampler adaptive` at a block: the centres of its pixels, of which smooth regions need only some
// (docs/sampling.md).
//
// A sampler is any callable Color(double x, double y); pixel centres have integer coordinates.
#pragma once

#include <array>
#include <vector>

#include "tracer/render/sampling/adaptive_settings.h"

namespace verisim::render {

class BlockCentres {
 public:
  struct Cell {
    Float4 color{0.0f};  // of the centre: traced or predicted
    Float4 mean{0.0f};   // of the pixel
    int samples = -1;    // the last one of those that were taken for an edge in the pixel
    bool wanted = false, chosen = false;
  };

  BlockCentres(const AdaptiveSettings& settings, int width, int height)
      : settings_(settings), width_(width), height_(height) {}

  // Traces a checkerboard of centres in the block and around it, and the others where these do not tell them; all of
  // them for fine tolerances.
  template <class Sampler>
  void trace(const Block& block, Sampler& sample) {
    left_ = std::max(block.x - 1, 0), right_ = std::min(block.x + block.width + 1, width_);
    top_ = std::max(block.y - 1, 0), bottom_ = std::min(block.y + block.height + 1, height_);
    cells_.assign(static_cast<std::size_t>(right_ - left_) * static_cast<std::size_t>(bottom_ - top_), {});
    shown_.resize(cells_.size());
    places_.clear();
    const bool all = settings_.tolerance < kFine;
    by_tiles(left_, top_, right_, bottom_, [&](int x, int y) {
      if (all || first(x, y)) want(x, y);
    });
    trace_wanted(sample);
    if (all) return;
    by_tiles(left_, top_, right_, bottom_, [&](int x, int y) {
      if (!first(x, y)) {
        if (!predict(x, y)) want(x, y);
      } else if (exceeds(off_line(x, y, 2), limit())) {
        for (const auto& [dx, dy] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
          if (inside(x + dx, y + dy)) want(x + dx, y + dy);
      }
    });
    while (!places_.empty()) trace_wanted(sample);
  }

  // Asks for a centre that is not traced yet.
  void want(int x, int y) {
    Cell& c = cell(x, y);
    if (c.wanted) return;
    c.wanted = true;
    places_.emplace_back(x, y);
  }
  // Traces the centres that were asked for, and asks for those near surprises; `traced()` tells which.
  template <class Sampler>
  void trace_wanted(Sampler& sample) {
    places_.swap(traced_);
    places_.clear();
    sample_points(sample, traced_, colors_);
    for (std::size_t i = 0; i < traced_.size(); ++i) {
      const int x = static_cast<int>(traced_[i].x), y = static_cast<int>(traced_[i].y);
      Cell& c = cell(x, y);
      c.color = c.mean = channels(colors_[i]);
      const Float4 now = as_shown(c.color, settings_.encoded);
      const bool surprise = !first(x, y) && exceeds(distance(now, shown(x, y)), limit());
      shown_[index(x, y)] = now;
      if (surprise) want_around(x, y);
    }
  }
  const std::vector<Vec2>& traced() const { return traced_; }
  bool complete() const { return places_.empty(); }

  void want_around(int x, int y) {
    for (int ny = std::max(y - 1, top_); ny <= std::min(y + 1, bottom_ - 1); ++ny)
      for (int nx = std::max(x - 1, left_); nx <= std::min(x + 1, right_ - 1); ++nx) want(nx, ny);
  }

  // Not beyond the picture, and at most one pixel beyond the block.
  bool inside(int x, int y) const { return x >= left_ && x < right_ && y >= top_ && y < bottom_; }
  Cell& cell(int x, int y) { return cells_[index(x, y)]; }
  const Cell& cell(int x, int y) const { return cells_[index(x, y)]; }
  // The colour of the centre as a file shows it.
  const Float4& shown(int x, int y) const { return shown_[index(x, y)]; }
  // The pixel that stands for (x, y): beyond the picture it goes on as at its border.
  int column(int x) const { return std::clamp(x, left_, right_ - 1); }
  int row(int y) const { return std::clamp(y, top_, bottom_ - 1); }
  const Cell& near(int x, int y) const { return cell(column(x), row(y)); }

  // How far the pixel lies off the lines between its neighbours on opposite sides: on a ramp its centre is the mean
  // already.
  Float4 uneven(int x, int y) const { return off_line(x, y, 1); }

 private:
  // Found by measurement over a dozen scenes (bench/sampling); none of them is critical.
  static constexpr float kFine = 0.006f;  // tolerances below begin with all centres
  static constexpr float kFill = 4;       // tolerances by which the first centres may lie off a plane

  static bool first(int x, int y) { return (x + y) % 2 == 0; }
  float limit() const { return kFill * settings_.tolerance; }

  std::size_t index(int x, int y) const { return static_cast<std::size_t>((y - top_) * (right_ - left_) + x - left_); }

  // Against the neighbours at a distance in the row and the column, and the next ones on the diagonals.
  Float4 off_line(int x, int y, int reach) const {
    const Float4* const here = &shown_[index(x, y)];
    const Float4 twice = *here + *here;
    const int stride = right_ - left_;
    if (x - reach >= left_ && x + reach < right_ && y - reach >= top_ && y + reach < bottom_) {
      const auto off = [&](int step) { return distance(twice, here[-step] + here[step]); };
      return max(max(off(reach), off(reach * stride)), max(off(stride + 1), off(stride - 1)));
    }
    const auto off = [&](int dx, int dy) {
      return distance(twice, (inside(x - dx, y - dy) ? here[-dy * stride - dx] : *here) +
                                 (inside(x + dx, y + dy) ? here[dy * stride + dx] : *here));
    };
    return max(max(off(reach, 0), off(0, reach)), max(off(1, 1), off(1, -1)));
  }

  // The colour of a centre from the four around it. False: they do not lie on a plane.
  bool predict(int x, int y) {
    const int stride = right_ - left_;
    const std::size_t here = index(x, y);
    Float4 color;
    bool plane;
    if (x > left_ && x + 1 < right_ && y > top_ && y + 1 < bottom_) {
      const Cell* const c = &cells_[here];
      const Float4* const s = &shown_[here];
      color = ((c[-1].color + c[1].color) + (c[-stride].color + c[stride].color)) * Float4(0.25f);
      plane = !exceeds(distance(s[-1] + s[1], s[-stride] + s[stride]), limit());
    } else {  // beside what is not known only equal ones are believed
      Float4 sum(0.0f);
      float n = 0;
      Float4 low(1.0f), high(0.0f);
      for (const auto& [dx, dy] : {std::array{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        if (!inside(x + dx, y + dy)) continue;
        sum = sum + cell(x + dx, y + dy).color, n += 1;
        low = min(low, shown(x + dx, y + dy)), high = max(high, shown(x + dx, y + dy));
      }
      if (n == 0) return false;
      color = sum * Float4(1 / n);
      plane = !exceeds(high - low, limit());
    }
    cells_[here].color = cells_[here].mean = color;
    shown_[here] = as_shown(color, settings_.encoded);
    return plane;
  }

  const AdaptiveSettings settings_;
  const int width_, height_;
  int left_ = 0, right_ = 0, top_ = 0, bottom_ = 0;
  std::vector<Cell> cells_;
  std::vector<Float4> shown_;
  std::vector<Vec2> places_, traced_;
  std::vector<Color> colors_;
};

}  // namespace verisim::render
