#include "tracer/shapes/swept/outline_index.h"

#include <cmath>

namespace verisim::shapes {

OutlineIndex::OutlineIndex(std::span<const Rectangle> pieces) : words_((pieces.size() + 63) / 64) {
  Rectangle all;
  for (const Rectangle& r : pieces) all.extendBy(r);
  for (int axis = 0; axis < 2; ++axis) {
    Axis& a = axis == 0 ? x_ : y_;
    const double size = all.max[axis] - all.min[axis];
    if (size > 0 && std::isfinite(kBands / size)) a = {all.min[axis], kBands / size};
    begun_[axis].resize(kBands * words_);
    unfinished_[axis].resize(kBands * words_);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const std::uint64_t bit = std::uint64_t{1} << i % 64;
      const std::size_t first = a.first(pieces[i].min[axis]), last = a.last(pieces[i].max[axis]);
      for (std::size_t band = first; band < kBands; ++band) begun_[axis][band * words_ + i / 64] |= bit;
      for (std::size_t band = 0; band <= last; ++band) unfinished_[axis][band * words_ + i / 64] |= bit;
    }
  }
}

}  // namespace verisim::shapes
