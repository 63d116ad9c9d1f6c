// Prisms with outlines of a few straight segments, in numbers: for what asks several rays at once.
#pragma once

#include <vector>

#include "tracer/math/transform.h"
#include "tracer/shapes/swept/outline_index.h"

namespace verisim::shapes {

// (dx w + x, dz w + z) for 0 <= w <= 1, and its bounds.
struct StraightSegment {
  double x, z, dx, dz;
  double x_low, x_high, z_low, z_high;
};

class StraightPrism {
 public:
  static constexpr std::size_t kMaxSegments = 16;
  static constexpr double kNearest = 1e-4, kFarthest = 1e7;  // of depths; those of caps in the prism's own space, too
  static bool within_reach(double t) { return t > kNearest && t < kFarthest; }

  struct Walls {
    const Transform* matrix;  // null: none
    bool inverted, open;
    double low, high;
    Rectangle outline;
    double size;  // the largest of all coordinates
    std::vector<StraightSegment> segments;
  };
  // Null: it is conic, clipped, has curves or too many segments.
  virtual const Walls* straight_walls() const = 0;

 protected:
  ~StraightPrism() = default;
};

}  // namespace verisim::shapes
