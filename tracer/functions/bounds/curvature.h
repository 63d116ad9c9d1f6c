// How much a user function can bend within a box: by interval arithmetic for its value and its first and second
// derivatives.
#pragma once

#include <array>

#include "tracer/functions/program.h"
#include "tracer/math/vec.h"

namespace verisim::functions {

struct Curvature {
  double bend;  // no second derivative along a unit vector is larger anywhere in the box; infinity: not known, or the
                // function has an edge there
  std::array<double, 6> parts;  // no second derivative by x x, y y, z z, x y, x z or y z is larger
  double error;  // how far computed values, even those of ProgramKernels::approximate, may be from the function's,
                 // where `bend` is finite
};

// For the boxes one after the other.
class CurvatureBounds {
 public:
  // A function of x, y and z. Its arguments may differ by `coordinate_error` from what they are meant to be.
  CurvatureBounds(const Program& program, double coordinate_error);
  ~CurvatureBounds();
  Curvature within(const Box3& box);

  struct Jet;

 private:
  const Program& program_;
  double coordinate_error_;
  std::vector<Jet> registers_;  // empty: nothing can be said
};

}  // namespace verisim::functions
