// Method 3 of media, level by level (spec 07 4.6): where POV-Ray halves one interval of a ray after the other, all
// intervals that are halved as often are halved together, so that densities and lights may be evaluated in batches.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "tracer/math/color.h"

namespace verisim::global {

// The result of one sample: source radiance and optical depth, both times the interval's length.
struct MediaSample {
  Rgb source, depth;
};
inline MediaSample operator+(const MediaSample& a, const MediaSample& b) {
  return {a.source + b.source, a.depth + b.depth};
}
inline MediaSample operator/(const MediaSample& a, float s) { return {a.source / s, a.depth / s}; }

// exp(-optical depth)
inline float transmitted(float optical_depth) {
  constexpr float kNothing = 104;  // leaves less than half the least number; the library is slow to find it out
  return optical_depth > kNothing ? 0.0f : std::exp(-optical_depth);
}
inline Rgb transmitted(const Rgb& optical_depth) {
  if (optical_depth == Rgb()) return Rgb(1.0f);
  return {transmitted(optical_depth.r), transmitted(optical_depth.g), transmitted(optical_depth.b)};
}

inline bool needs_refinement(const MediaSample& a, const MediaSample& b, double threshold) {
  return std::fabs(a.source.r - b.source.r) + std::fabs(a.source.g - b.source.g) + std::fabs(a.source.b - b.source.b) >
         threshold;
}

inline double middle_of(double d1, double d3) { return 0.5 * (d1 + d3); }

// The mean over an interval with a sample at either end and in the middle; left() and right(): those over its halves,
// where the brightness changes.
template <class Left, class Right>
MediaSample mean_of_interval(const MediaSample& s1, const MediaSample& s2, const MediaSample& s3, int level,
                             double threshold, Left&& left, Right&& right) {
  if (level <= 0) return (s1 + s2 + s3) / 3.0f;
  const MediaSample before = needs_refinement(s1, s2, threshold) ? left() / 2.0f : s1 / 3.0f + s2 / 6.0f;
  const MediaSample behind = needs_refinement(s2, s3, threshold) ? right() / 2.0f : s2 / 6.0f + s3 / 3.0f;
  return before + behind;
}

// The mean over an interval: interval(k) is that over interval k of its grid. A left Riemann rule for attenuation.
template <class Subinterval>
MediaSample mean_of_interval(int subintervals, Subinterval&& subinterval) {
  const auto count = static_cast<float>(subintervals);
  MediaSample result;
  Rgb before;
  for (int k = 0; k < subintervals; ++k) {
    const MediaSample part = subinterval(k);
    result.source += part.source * transmitted(before / count);
    before += part.depth;
  }
  result.source = result.source / count;
  result.depth = before / count;
  return result;
}

class MediaRefinement {
 public:
  // d1, d3: places in an interval, 0 to 1, with samples s1 and s3; s2 is the one between.
  struct Subinterval {
    double d1 = 0, d3 = 0;
    MediaSample s1, s2, s3;
    std::uint32_t interval = 0;  // as the caller numbers them
    int left = -1, right = -1;   // its halves that are refined
    double middle() const { return middle_of(d1, d3); }
  };
  static constexpr int kMaxLevels = 5;  // a caller goes on alone: there might be any number of intervals behind

  std::vector<Subinterval> subintervals;

  // Halves those from `begin` on where the brightness changes: returns the first of the halves, whose s2 is to be
  // found.
  std::size_t halve(std::size_t begin, double threshold) {
    const std::size_t end = subintervals.size();
    for (std::size_t i = begin; i < end; ++i) {
      const Subinterval s = subintervals[i];
      if (needs_refinement(s.s1, s.s2, threshold)) {
        subintervals[i].left = static_cast<int>(subintervals.size());
        subintervals.push_back({s.d1, s.middle(), s.s1, {}, s.s2, s.interval});
      }
      if (needs_refinement(s.s2, s.s3, threshold)) {
        subintervals[i].right = static_cast<int>(subintervals.size());
        subintervals.push_back({s.middle(), s.d3, s.s2, {}, s.s3, s.interval});
      }
    }
    return end;
  }

  // The mean over an interval that may be halved `level` times; alone(interval, s1, d1, s3, d3, level): over one that
  // was not halved here.
  template <class Alone>
  MediaSample mean(std::size_t number, int level, double threshold, Alone&& alone) const {
    const Subinterval& s = subintervals[number];
    const auto half = [&](int child, const MediaSample& s1, double d1, const MediaSample& s3, double d3) {
      return child >= 0 ? mean(static_cast<std::size_t>(child), level - 1, threshold, alone)
                        : alone(s, s1, d1, s3, d3, level - 1);
    };
    return mean_of_interval(
        s.s1, s.s2, s.s3, level, threshold, [&] { return half(s.left, s.s1, s.d1, s.s2, s.middle()); },
        [&] { return half(s.right, s.s2, s.middle(), s.s3, s.d3); });
  }
};

}  // namespace verisim::global
