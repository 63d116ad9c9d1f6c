// Looking a value up in a map of positions (spec 05 section 4.1).
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace verisim::textures {

// Entry `upper` alone (t = 1, lower = upper), or a blend: lower + t * (upper - lower).
struct MapPlace {
  int lower, upper;
  float t;
  bool single() const { return lower == upper; }
};

// The positions of a map in the order written; they are never sorted. The first entry with v <= position is found by binary search on the
// running maximum of the positions, which has the same answer for any order.
class MapPositions {
 public:
  MapPositions() = default;
  template <class Entries>
  explicit MapPositions(const Entries& entries) {
    for (const auto& entry : entries) {
      positions_.push_back(entry.position);
      running_maximum_.push_back(running_maximum_.empty() ? entry.position : std::max(running_maximum_.back(), entry.position));
    }
  }

  std::size_t size() const { return positions_.size(); }
  float position(std::size_t i) const { return positions_[i]; }

  // The map must not be empty.
  MapPlace find(double v) const {
    const int last = static_cast<int>(positions_.size()) - 1;
    if (!(v < positions_[last])) return {last, last, 1};
    int j = 0;
    if (last < 12) {
      while (v > running_maximum_[j]) ++j;
    } else {
      j = static_cast<int>(std::lower_bound(running_maximum_.begin(), running_maximum_.end(), v,
                                            [](float position, double value) { return position < value; }) -
                           running_maximum_.begin());
    }
    if (j == 0 || v == positions_[j]) return {j, j, 1};
    // Width and fraction are rounded to single precision, the difference from the position is not (probe P9).
    const float low = positions_[j - 1];
    return {j - 1, j, static_cast<float>((v - low) / (positions_[j] - low))};
  }

 private:
  std::vector<float> positions_, running_maximum_;
};

}  // namespace verisim::textures
