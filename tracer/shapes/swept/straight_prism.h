// Prisms with outlines of a few straight segments, in numbers: for what asks several rays at once.
#pragma once

#include <vector>

#include "tracer/math/transform.h"
#include "tracer/shapes/swept/outline_index.h"

namespace verisim::shapes {

// (dx w + x, dz w + z) for 0 <= w <= 1.
struct StraightSegment {
  double x, z, dx, dz;
};
struct BoundedSegment : StraightSegment {
  double x_low, x_high, z_low, z_high;
};

class StraightPrism {
 public:
  static constexpr std::size_t kMaxSegments = 16;

  struct Walls {
    const Transform* matrix;  // null: none
    bool inverted, open;
    double low, high;
    Rectangle outline;
    double size;  // the largest of all coordinates
    std::vector<BoundedSegment> segments;
  };
  // Null: it is conic, clipped, has curves or too many segments.
  virtual const Walls* straight_walls() const = 0;

 protected:
  ~StraightPrism() = default;
};

}  // namespace verisim::shapes
