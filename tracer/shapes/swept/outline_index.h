// Finds the pieces of a plane outline that may lie in a rectangle, for prisms and glyphs: their bounds are sorted into
// bands of both axes, as sets of bits. A piece may meet the rectangle if along each axis it begins before the rectangle
// ends and ends after it begins, so four sets decide.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <ImathBox.h>

#include "tracer/math/vec.h"

namespace verisim::shapes {

using Rectangle = Imath::Box<Vec2>;

class OutlineIndex {
 public:
  OutlineIndex() = default;
  explicit OutlineIndex(std::span<const Rectangle> pieces);

  // Calls visit(i) for every piece whose bounds overlap the rectangle (and for some that narrowly do not), i
  // increasing. Numbers that are none: everywhere.
  template <class Visit>
  void overlapping(const Rectangle& r, Visit&& visit) const {
    if (words_ == 0) return;
    const std::uint64_t *a = &begun_[0][words_ * x_.last(r.max.x)], *b = &unfinished_[0][words_ * x_.first(r.min.x)];
    const std::uint64_t *c = &begun_[1][words_ * y_.last(r.max.y)], *d = &unfinished_[1][words_ * y_.first(r.min.y)];
    for (std::size_t w = 0; w < words_; ++w) {
      for (std::uint64_t bits = a[w] & b[w] & c[w] & d[w]; bits != 0; bits &= bits - 1) {
        visit(64 * w + static_cast<std::size_t>(__builtin_ctzll(bits)));
      }
    }
  }

 private:
  static constexpr std::size_t kBands = 32;

  // The band of a coordinate never falls as the coordinate grows, so bands of overlapping intervals overlap, however
  // they are rounded.
  struct Axis {
    double low = 0, bands_per_unit = 0;
    std::size_t first(double v) const {
      const double band = (v - low) * bands_per_unit;
      return band > 0 ? static_cast<std::size_t>(band < kBands - 1 ? band : kBands - 1) : 0;
    }
    std::size_t last(double v) const { return v == v ? first(v) : kBands - 1; }
  };

  Axis x_, y_;
  std::size_t words_ = 0;  // of a set
  // For each band of an axis: the pieces that begin in it or before, and those that end in it or behind.
  std::vector<std::uint64_t> begun_[2], unfinished_[2];
};

}  // namespace verisim::shapes
