// A straight edge across a pixel, known from samples on both sides of it: how much of the pixel lies on either side,
// and how sure that is.
//
// Places are relative to the pixel's centre, the pixel is [-0.5, 0.5]^2.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tracer/simd/float4.h"

namespace verisim::render {

using accel::Float4;

// Four families of half-planes nx * x + ny * y < d, for unit normals.
class HalfPlanes {
 public:
  HalfPlanes() = default;
  HalfPlanes(const float* nx, const float* ny) {
    for (int k = 0; k < 4; ++k) {
      const float a = std::max(std::fabs(nx[k]), std::fabs(ny[k])), b = std::min(std::fabs(nx[k]), std::fabs(ny[k]));
      from_[k] = 0.5f * (a - b), to_[k] = 0.5f * (a + b);
      slope_[k] = 1 / a, bend_[k] = 1 / (2 * a * std::max(b, 1e-12f));
    }
  }
  // The part of the pixel that lies in them: the integral of a box's width, straight in the middle, a parabola where
  // the edge cuts off a corner.
  Float4 coverage(Float4 d) const {
    const Float4 zero(0.0f), t = max(d, zero - d), corner = max(Float4::load(to_) - t, zero);
    const Float4 beyond = select(t <= Float4::load(from_), Float4(0.5f) - Float4::load(slope_) * t,
                                 Float4::load(bend_) * corner * corner);  // not on the centre's side
    return select(zero <= d, Float4(1.0f) - beyond, beyond);
  }

 private:
  alignas(16) float from_[4], to_[4], slope_[4], bend_[4];
};

// All half-planes that part two sets of points, by directions of the normal: for each the range of offsets.
class EdgeModel {
 public:
  static constexpr int kDirections = 24;  // over half a turn, a multiple of four; the others are their opposites
  static constexpr float kSlack =
      0.06f;  // pixels by which a point may lie on the wrong side: edges are curved, directions are few

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
    const Float4 zero(0.0f), slack(kSlack), half(0.5f), third(1.0f / 3);
    Float4 weight = zero, first = zero, second = zero, nx = zero, ny = zero, d = zero;
    for (int k = 0; k < kDirections; k += 4) {
      const Float4 low0 = Float4::load(&sides_[0].low[k]), high0 = Float4::load(&sides_[0].high[k]);
      const Float4 low1 = Float4::load(&sides_[1].low[k]), high1 = Float4::load(&sides_[1].high[k]);
      const Float4 up = low1 - high0, down = low0 - high1, gap = max(max(up, down) + slack, zero);
      if ((gap <= zero).bits() == 15) continue;
      const auto along = up <= down;  // the normal points from the second side to the first one
      const Float4 offset =
          select(along, half * (low0 + high1), zero - half * (low1 + high0));  // of the second side's half-plane
      for (const Float4 at : {offset - third * gap, offset, offset + third * gap}) {
        const Float4 covered = n.half_planes[k / 4].coverage(at);
        first = first + gap * covered;
        second = second + gap * covered * covered;
      }
      weight = weight + gap;
      const Float4 signed_gap = select(along, zero - gap, gap);
      nx = nx + signed_gap * Float4::load(&n.x[k]), ny = ny + signed_gap * Float4::load(&n.y[k]), d = d - gap * offset;
    }
    Estimate e;
    const float sum = sum_of(weight);
    if (!(sum > 0)) return e;
    e.possible = true;
    e.coverage = sum_of(first) / (3 * sum);
    e.deviation = std::sqrt(std::max(0.0f, sum_of(second) / (3 * sum) - e.coverage * e.coverage));
    const float x = sum_of(nx), y = sum_of(ny), length = std::max(std::sqrt(x * x + y * y), 1e-6f);
    e.nx = x / length, e.ny = y / length, e.d = sum_of(d) / length;
    return e;
  }

 private:
  static constexpr float kFar = 8;
  static float sum_of(Float4 v) {
    alignas(16) float lanes[4];
    v.store(lanes);
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
  }
  struct Side {
    alignas(16) std::array<float, kDirections> low, high;
  };
  struct Directions {
    alignas(16) std::array<float, kDirections> x, y;
    std::array<HalfPlanes, kDirections / 4> half_planes;
    Directions() {
      for (int k = 0; k < kDirections; ++k) {
        const double angle = std::numbers::pi * (k + 0.5) / kDirections;
        x[k] = static_cast<float>(std::cos(angle)), y[k] = static_cast<float>(std::sin(angle));
      }
      for (int k = 0; k < kDirections; k += 4) half_planes[k / 4] = HalfPlanes(&x[k], &y[k]);
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
      for (int k = 0; k < 9; ++k)
        result[i].model.add(static_cast<float>(k % 3 - 1), static_cast<float>(k / 3 - 1), i >> k & 1);
      result[i].estimate = result[i].model.estimate();
    }
    return result;
  }();
  return all[bits];
}

}  // namespace verisim::render
