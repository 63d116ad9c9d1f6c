// Turning samples into the pixels of one block: plain, and POV-Ray's anti-aliasing methods 1 and 2 (spec 02 section 3).
//
// A sampler is any callable Color(double x, double y); pixel centres have integer coordinates. Blocks are independent
// of each other, so the picture does not depend on which thread renders which block.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tracer/world/coherent_rays.h"
#include "tracer/render/sampling/jitter.h"
#include "tracer/film/framebuffer.h"
#include "tracer/film/options.h"

namespace verisim::render {

struct Block {
  int x, y, width, height;
};

// Where the pixels of a block are written, by the columns and rows that they have in the picture.
struct BlockPixels {
  // `left`, `top`: what to take away from them; 0 for a framebuffer of the picture.
  BlockPixels(Framebuffer& frame, int left = 0, int top = 0) : frame_(frame), left_(left), top_(top) {}
  PixelColor& at(int x, int y) const { return frame_.at(x - left_, y - top_); }

 private:
  Framebuffer& frame_;
  int left_, top_;
};

struct AntialiasSettings {
  int method = 1;  // 1 or 2
  int depth = 3;
  float threshold = 0.3f;
  double jitter = 1;  // scale; 0: none
  // Colours are compared after max(c, 0)^exponent, or after decoding sRGB first (spec 02 section 3.3).
  float exponent = 1;
  bool identity = true, decode_srgb = false;
};
AntialiasSettings antialias_settings(const Options& options, scene::Gamma working, double working_gamma);

// Tells whether two samples differ so much that there must be more between them.
class SampleComparison {
 public:
  explicit SampleComparison(const AntialiasSettings& settings);

  // A colour for `differ`.
  struct Sample {
    Color color;
    float r = 0, g = 0, b = 0;  // encoded, to about 1e-4
  };
  Sample sample(const Color& color) const;
  bool differ(const Sample& a, const Sample& b) const {
    const float difference =
        std::fabs(a.r - b.r) + std::fabs(a.g - b.g) + std::fabs(a.b - b.b) + std::fabs(a.color.t - b.color.t);
    if (difference >= certain_) return true;
    if (difference < certainly_not_) return false;
    return truly_differ(a.color, b.color);
  }

 private:
  float encode(float v) const;
  float look_up(float v) const;
  bool truly_differ(const Color& a, const Color& b) const;

  // The upper bits of floats from 2^-14 to 2 tell the cell.
  static constexpr std::uint32_t kShift = 18, kFirst = 0x38800000 >> kShift, kCells = (0x40000000 >> kShift) - kFirst;
  const AntialiasSettings settings_;
  float certain_, certainly_not_;           // differences that the error of `look_up` does not change
  std::array<float, kCells + 1> values_{};  // where cells begin
};

// Samples at (x, y), (x + 1, y) ...; together, if the sampler knows how.
template <class Sampler>
void sample_batch(Sampler& sample, double x, double y, int count, Color* colors) {
  if constexpr (requires { sample.row(x, y, count, colors); }) {
    sample.row(x, y, count, colors);
  } else {
    for (int i = 0; i < count; ++i) colors[i] = sample(x + i, y);
  }
}
// Samples at any places near each other; together, if the sampler knows how.
template <class Sampler>
void sample_points(Sampler& sample, const std::vector<Vec2>& places, std::vector<Color>& colors) {
  colors.resize(places.size());
  if constexpr (requires { sample.points(places.data(), 1, colors.data()); }) {
    sample.points(places.data(), static_cast<int>(places.size()), colors.data());
  } else {
    for (std::size_t i = 0; i < places.size(); ++i) colors[i] = sample(places[i].x, places[i].y);
  }
}
// Calls f(x, y) for all pixels of a rectangle, one tile of the camera's rays after another: those go together through
// the scene.
template <class F>
void by_tiles(int left, int top, int right, int bottom, F&& f) {
  constexpr int kTile = accel::CoherentRays::camera_tile();
  const auto beyond = [](int v) { return (v / kTile + 1) * kTile; };
  for (int y0 = top, y1; y0 < bottom; y0 = y1) {
    y1 = std::min(beyond(y0), bottom);
    for (int x0 = left, x1; x0 < right; x0 = x1) {
      x1 = std::min(beyond(x0), right);
      for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) f(x, y);
    }
  }
}

// Samples may be taken in any order; if not, random numbers would be drawn in another one.
template <class Sampler>
bool any_order(const Sampler& sample) {
  if constexpr (requires { sample.any_order(); })
    return sample.any_order();
  else
    return true;
}

template <class Sampler>
void render_plain(const Block& block, Sampler&& sample, const BlockPixels& out) {
  std::vector<Color> row(static_cast<std::size_t>(block.width));
  for (int y = block.y; y < block.y + block.height; ++y) {
    sample_batch(sample, block.x, y, block.width, row.data());
    std::ranges::copy(row, &out.at(block.x, y));
  }
}

// Method 1: pixels that differ from the one on the left or above are replaced by an average over a jittered grid.
template <class Sampler>
class AdaptiveGrid {
 public:
  AdaptiveGrid(const AntialiasSettings& settings, Sampler& sample)
      : settings_(settings), comparison_(settings), sample_(sample) {}

  void render(const Block& block, const BlockPixels& out) {
    stride_ = block.width + 1;
    cells_.assign(static_cast<std::size_t>(stride_) * (block.height + 1), {});
    origin_x_ = block.x - 1, origin_y_ = block.y - 1;
    // The row above and the column on the left only serve as comparison.
    for (int x = block.x; x < block.x + block.width; ++x) cell(x, origin_y_).done = true;
    for (int y = block.y; y < block.y + block.height; ++y) cell(origin_x_, y).done = true;
    if (any_order(sample_))
      refine_together(block);
    else
      refine_in_order(block);
    for (int y = block.y; y < block.y + block.height; ++y)
      for (int x = block.x; x < block.x + block.width; ++x) out.at(x, y) = cell(x, y).seen.color;
  }

 private:
  struct Cell {
    SampleComparison::Sample seen;
    bool done = false;  // supersampled already, or not to be
  };
  Cell& cell(int x, int y) { return cells_[static_cast<std::size_t>(y - origin_y_) * stride_ + (x - origin_x_)]; }

  void set(Cell& c, const Color& color) { c.seen = comparison_.sample(color); }

  void trace_centres(int x, int y, int count) {
    row_.resize(static_cast<std::size_t>(count));
    sample_batch(sample_, x, y, count, row_.data());
    for (int i = 0; i < count; ++i) set(cell(x + i, y), row_[static_cast<std::size_t>(i)]);
  }

  void refine_in_order(const Block& block) {
    trace_centres(block.x, origin_y_, block.width);
    for (int y = block.y; y < block.y + block.height; ++y) {
      trace_centres(origin_x_, y, 1);
      for (int x = block.x; x < block.x + block.width; ++x) {
        trace_centres(x, y, 1);
        refine(x, y);
        supersample();
      }
    }
  }
  // The same with many samples at a time. What a pixel asks for hangs on the pixels on the left and above, and on those
  // that these were asked for by: the one at (x, y) on those up to (x - 1, y) in its row and up to (x + 1, y - 1) in
  // the row above. So those of all rows with the same x + 2y wait for the same ones.
  void refine_together(const Block& block) {
    by_tiles(origin_x_, origin_y_, block.x + block.width, block.y + block.height, [&](int x, int y) {
      if (x != origin_x_ || y != origin_y_) places_.emplace_back(x, y);
    });
    sample_points(sample_, places_, row_);
    for (std::size_t i = 0; i < places_.size(); ++i)
      set(cell(static_cast<int>(places_[i].x), static_cast<int>(places_[i].y)), row_[i]);
    places_.clear();
    for (int front = 0; front < block.width + 2 * (block.height - 1); ++front) {
      for (int y = std::max(0, (front - block.width) / 2); y < block.height && 2 * y <= front; ++y)
        if (const int x = front - 2 * y; x < block.width) refine(block.x + x, block.y + y);
      supersample();
    }
  }

  void refine(int x, int y) {
    const Cell &here = cell(x, y), &left = cell(x - 1, y), &top = cell(x, y - 1);
    const bool left_differs = comparison_.differ(here.seen, left.seen);
    const bool top_differs = comparison_.differ(here.seen, top.seen);
    if (left_differs) ask(x - 1, y);
    if (top_differs) ask(x, y - 1);
    if (left_differs || top_differs) ask(x, y);
  }

  void ask(int x, int y) {
    Cell& c = cell(x, y);
    if (c.done) return;
    c.done = true;
    waiting_.push_back(&c);
    const int n = settings_.depth;
    const double step = 1.0 / n, first = -0.5 + 0.5 * step, scale = settings_.jitter / n;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const double sx = x + (first + i * step), sy = y + (first + j * step);
        const Vec2 d = scale == 0 ? Vec2(0, 0) : jitter2(sx, sy) * scale;
        places_.emplace_back(sx + d.x, sy + d.y);
      }
    }
  }

  // The pixels that wait.
  void supersample() {
    if (waiting_.empty()) return;
    sample_points(sample_, places_, row_);
    const std::size_t samples = places_.size() / waiting_.size();
    const auto count = static_cast<float>(samples + 1);
    for (std::size_t k = 0; k < waiting_.size(); ++k) {
      Color sum = waiting_[k]->seen.color;
      for (std::size_t i = 0; i < samples; ++i) sum += row_[k * samples + i];
      set(*waiting_[k], {sum.r / count, sum.g / count, sum.b / count, sum.f / count, sum.t / count});
    }
    waiting_.clear();
    places_.clear();
  }

  const AntialiasSettings settings_;
  const SampleComparison comparison_;
  Sampler& sample_;
  int stride_ = 0, origin_x_ = 0, origin_y_ = 0;
  std::vector<Cell> cells_;
  std::vector<Cell*> waiting_;
  std::vector<Vec2> places_;
  std::vector<Color> row_;
};

// Method 2: pixels whose corners differ are divided into quadrants, recursively.
template <class Sampler>
class RecursiveQuads {
 public:
  RecursiveQuads(const AntialiasSettings& settings, Sampler& sample)
      : settings_(settings),
        comparison_(settings),
        sample_(sample),
        side_((1 << (settings.depth - 1)) + 1),
        points_(static_cast<std::size_t>(side_) * side_) {}

  void render(const Block& block, const BlockPixels& out) {
    const int stride = block.width + 1;
    corners_.resize(static_cast<std::size_t>(stride) * (block.height + 1));
    row_.resize(static_cast<std::size_t>(stride));
    for (int y = 0; y <= block.height; ++y) {
      sample_batch(sample_, block.x - 0.5, block.y + y - 0.5, stride, row_.data());
      for (int x = 0; x <= block.width; ++x)
        set(corners_[static_cast<std::size_t>(y) * stride + x], row_[static_cast<std::size_t>(x)]);
    }
    for (int y = 0; y < block.height; ++y) {
      for (int x = 0; x < block.width; ++x) {
        ++stamp_;
        pixel_x_ = block.x + x - 0.5, pixel_y_ = block.y + y - 0.5;
        const int last = side_ - 1;
        const Point* c = &corners_[static_cast<std::size_t>(y) * stride + x];
        at(0, 0) = c[0], at(last, 0) = c[1], at(0, last) = c[stride], at(last, last) = c[stride + 1];
        for (Point* p : {&at(0, 0), &at(last, 0), &at(0, last), &at(last, last)}) p->stamp = stamp_;
        out.at(block.x + x, block.y + y) = quad(0, 0, last, settings_.depth - 1);
      }
    }
  }

 private:
  struct Point {
    SampleComparison::Sample seen;
    std::uint64_t stamp = 0;  // of the pixel it was traced for
  };
  Point& at(int i, int j) { return points_[static_cast<std::size_t>(j) * side_ + i]; }
  void set(Point& p, const Color& color) {
    p.seen = comparison_.sample(color);
    p.stamp = stamp_;
  }

  void ask(int i, int j) {
    Point& p = at(i, j);
    if (p.stamp == stamp_) return;
    if (waiting_.empty()) places_.clear();
    waiting_.push_back(&p);
    const double step = 1.0 / (side_ - 1), x = pixel_x_ + i * step, y = pixel_y_ + j * step;
    const double scale = settings_.jitter / ((1 << settings_.depth) + 1);
    const Vec2 d = scale == 0 ? Vec2(0, 0) : jitter2(x, y) * scale;
    places_.emplace_back(x + d.x, y + d.y);
  }
  void trace_waiting() {
    if (waiting_.empty()) return;
    sample_points(sample_, places_, row_);
    for (std::size_t k = 0; k < waiting_.size(); ++k) set(*waiting_[k], row_[k]);
    waiting_.clear();
  }

  // The quadrant with its top left corner at (i, j) of the pixel's grid.
  Color quad(int i, int j, int size, int levels) {
    const Point corner[4] = {at(i, j), at(i + size, j), at(i, j + size), at(i + size, j + size)};
    bool differ = false;
    for (int a = 0; levels > 0 && a < 3; ++a)
      for (int b = a + 1; b < 4; ++b) differ = differ || comparison_.differ(corner[a].seen, corner[b].seen);
    if (!differ)
      return (corner[0].seen.color + corner[2].seen.color + corner[1].seen.color + corner[3].seen.color) * 0.25f;
    const int half = size / 2;
    ask(i, j + half), ask(i + half, j), ask(i + size, j + half), ask(i + half, j + size), ask(i + half, j + half);
    trace_waiting();
    Color sum = quad(i, j, half, levels - 1);
    sum += quad(i, j + half, half, levels - 1);
    sum += quad(i + half, j, half, levels - 1);
    sum += quad(i + half, j + half, half, levels - 1);
    return sum * 0.25f;
  }

  const AntialiasSettings settings_;
  const SampleComparison comparison_;
  Sampler& sample_;
  int side_;
  double pixel_x_ = 0, pixel_y_ = 0;
  std::uint64_t stamp_ = 1;
  std::vector<Point> points_, corners_;
  std::vector<Point*> waiting_;
  std::vector<Vec2> places_;
  std::vector<Color> row_;
};

}  // namespace verisim::render
