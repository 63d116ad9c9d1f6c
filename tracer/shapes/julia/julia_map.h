// Where a Julia fractal can be: the cells of a cube that may hold points of the set. A ray's march is followed exactly
// (spec 04 section 8), but need not be begun where it meets none of them, nor continued behind the last. Cells are
// discarded by following their centre and a bound of how far the images of their other points stray from it.
#pragma once

#include "tracer/shapes/julia/julia_packet.h"

namespace verisim::shapes::julia {

class Map {
 public:
  // Of powers.
  explicit Map(const Field& field);

  // The last distance in begin .. end at which the ray is in a cell that may hold points of the set; negative if there
  // is none.
  double last(const Vec3& origin, const Vec3& direction, double begin, double end) const;
  const Grid& grid() const { return grid_; }

 private:
  bool may_hold(const Field& field, const Vec3& center, double half) const;
  void fill(const Field& field, int i, int j, int k, int size);

  Grid grid_;
};

}  // namespace verisim::shapes::julia
