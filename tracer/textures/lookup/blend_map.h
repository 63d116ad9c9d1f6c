// Looking a value up in a map of positions (spec 05 section 4.1).
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tracer/math/color.h"

namespace verisim::textures {

// Entry `upper` alone (t = 1, lower = upper), or a blend: lower + t * (upper - lower).
struct MapPlace {
  int lower, upper;
  double t;
  bool single() const { return lower == upper; }
};

// The way from one colour to another: products are of double precision, rounded before the sum (spec 05 4.1).
inline float blended(float lower, float rise, double t) { return lower + static_cast<float>(rise * t); }
inline Color blended(const Color& lower, const Color& upper, double t) {
  const Color rise = upper - lower;
  return {blended(lower.r, rise.r, t), blended(lower.g, rise.g, t), blended(lower.b, rise.b, t),
          blended(lower.f, rise.f, t), blended(lower.t, rise.t, t)};
}

// The positions of a map in the order written; they are never sorted. The first entry with v <= position is found by
// counting (long maps: searching) the smaller ones among the running maxima of the positions, which has the same answer
// for any order.
class MapPositions {
 public:
  MapPositions() = default;
  template <class Entries>
  explicit MapPositions(const Entries& entries) {
    for (const auto& e : entries) {
      const float position = e.position;
      if (entries_.empty())
        entries_.push_back({position, position, position, 0});
      else
        entries_.push_back({std::max<double>(entries_.back().running_maximum, position), position,
                            entries_.back().position, position - entries_.back().position});
    }
  }

  std::size_t size() const { return entries_.size(); }
  float position(std::size_t i) const { return entries_[i].position; }

  // The map must not be empty.
  MapPlace find(double v) const {
    const Entry* entries = entries_.data();
    const int last = static_cast<int>(entries_.size()) - 1;
    if (v >= entries[last].position) return {last, last, 1};  // what is no number finds the first entry
    int j = 0;
    if (last <= 8) {
      for (int i = 0; i < last; ++i) j += v > entries[i].running_maximum;
    } else {
      j = static_cast<int>(std::lower_bound(entries, entries + last, v,
                                            [](const Entry& e, double value) { return e.running_maximum < value; }) -
                           entries);
    }
    const Entry& e = entries[j];
    if (j == 0 || v == e.position) return {j, j, 1};
    // The width is rounded to single precision, the rest is not (probe P9).
    return {j - 1, j, (v - e.low) / e.width};
  }

 private:
  struct Entry {
    double running_maximum;
    float position, low, width;  // low: the position before
  };
  std::vector<Entry> entries_;
};

}  // namespace verisim::textures
