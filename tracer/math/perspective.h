// The view of a camera whose rays are linear in the place of the picture (spec 02 section 1.5): written for one place,
// and inlined into kernels that make many rays.
#pragma once

#include "tracer/math/vec.h"

namespace verisim {

struct PerspectiveView {
  double width, height;  // of the picture
  double left, top;      // of what is rendered of it
  Vec3 direction, right, up;

  // A fractional pixel position, pixels' centres at integers, as parts of the picture: from the left and from below.
  // In this form: the last bits decide where a pattern's seam lies in a surface, and where a march through a fractal
  // begins (spec 02 1.5).
  Vec2 place(double x, double y) const { return {(x + left + 0.5) / width, (height - 1 - (y + top) + 0.5) / height}; }
  // What is seen there through the middle of the picture's plane; not of unit length.
  Vec3 through(const Vec2& place) const { return direction + (place.x - 0.5) * right + (place.y - 0.5) * up; }
};

}  // namespace verisim
