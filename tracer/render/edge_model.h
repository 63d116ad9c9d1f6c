// A straight edge across a pixel, known from samples on both sides of it: how much of the pixel lies on either side, and how sure that is.
//
// Places are relative to the pixel's centre, the pixel is [-0.5, 0.5]^2.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace verisim::render {

// The part of the pixel with nx * x + ny * y < d, for a unit normal: the integral of a box's width, a sum of four squares.
inline float half_plane_coverage(float nx, float ny, float d) {
  const float a = std::max(std::fabs(nx), std::fabs(ny)), b = std::min(std::fabs(nx), std::fabs(ny));
  const float from = 0.5f * (a - b), to = 0.5f * (a + b);
  const float t = std::fabs(d);
  float beyond;  // what lies on the other side of the centre's side
  if (t >= to) beyond = 0;
  else if (t <= from) beyond = 0.5f - t / a;
  else beyond = (to - t) * (to - t) / (2 * a * b);
  return d < 0 ? beyond : 1 - beyond;
}

// All half-planes that part two sets of points, by directions of the normal: for each the range of offsets.
class EdgeModel {
 public:
  static constexpr int kDirections = 24;  // over half a turn; the others are their opposites
  static constexpr float kSlack = 0.06f;  // pixels by which a point may lie on the wrong side: edges are curved, directions are few

  struct Estimate {
    bool possible = false;
    float coverage = 0, deviation = 0;  // of the second side
    float nx = 0, ny = 0, d = 0;        // the middle edge; the normal points to the second side
  };

  // Of the centres of 3x3 pixels, bit 3 * row + column set for the second side: most of what is asked.
  struct Centres;
  static const Centres& of_centres(unsigned bits);

  void clear() {
    for (Side& side : sides_) side.low.fill(kFar), side.high.fill(-kFar);
  }
  void add(float x, float y, bool second) {
    Side& side = sides_[second];
    const Directions& n = directions();
    for (int k = 0; k < kDirections; ++k) {
      const float p = n.x[k] * x + n.y[k] * y;
      side.low[k] = std::min(side.low[k], p);
      side.high[k] = std::max(side.high[k], p);
    }
  }

  // Means over all possible edges, with the measure of lines that does not change with motions: direction times offset.
  Estimate estimate() const {
    const Directions& n = directions();
    float weight = 0, first = 0, second = 0, nx = 0, ny = 0, d = 0;
    for (int k = 0; k < kDirections; ++k) {
      const float up = sides_[1].low[k] - sides_[0].high[k], down = sides_[0].low[k] - sides_[1].high[k];
      const float gap = std::max(up, down) + kSlack;
      if (gap <= 0) continue;
      const float sign = up > down ? 1.0f : -1.0f;
      const float middle = up > down ? 0.5f * (sides_[1].low[k] + sides_[0].high[k]) : 0.5f * (sides_[0].low[k] + sides_[1].high[k]);
      for (const float part : {-1.0f / 3, 0.0f, 1.0f / 3}) {
        const float c = half_plane_coverage(n.x[k], n.y[k], middle + part * gap), covered = up > down ? 1 - c : c;
        first += gap * covered;
        second += gap * covered * covered;
      }
      weight += gap;
      nx += gap * sign * n.x[k], ny += gap * sign * n.y[k], d += gap * sign * middle;
    }
    if (!(weight > 0)) return {};
    Estimate e;
    e.possible = true;
    e.coverage = first / (3 * weight);
    e.deviation = std::sqrt(std::max(0.0f, second / (3 * weight) - e.coverage * e.coverage));
    const float length = std::max(std::sqrt(nx * nx + ny * ny), 1e-6f);
    e.nx = nx / length, e.ny = ny / length, e.d = d / length;
    return e;
  }

 private:
  static constexpr float kFar = 8;
  struct Side {
    std::array<float, kDirections> low, high;
  };
  struct Directions {
    std::array<float, kDirections> x, y;
    Directions() {
      for (int k = 0; k < kDirections; ++k) {
        const double angle = std::numbers::pi * (k + 0.5) / kDirections;
        x[k] = static_cast<float>(std::cos(angle)), y[k] = static_cast<float>(std::sin(angle));
      }
    }
  };
  static const Directions& directions() {
    static const Directions all;
    return all;
  }
  std::array<Side, 2> sides_;
};

struct EdgeModel::Centres {
  EdgeModel model;
  Estimate estimate;
};

inline const EdgeModel::Centres& EdgeModel::of_centres(unsigned bits) {
  static const auto all = [] {
    std::vector<Centres> result(512);
    for (unsigned i = 0; i < result.size(); ++i) {
      result[i].model.clear();
      for (int k = 0; k < 9; ++k) result[i].model.add(static_cast<float>(k % 3 - 1), static_cast<float>(k / 3 - 1), i >> k & 1);
      result[i].estimate = result[i].model.estimate();
    }
    return result;
  }();
  return all[bits];
}

}  // namespace verisim::render
