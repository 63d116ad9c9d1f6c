// Four-dimensional numbers of julia_fractal: quaternions and the commutative hypercomplex numbers (spec 04 section 8).
#pragma once

#include <array>
#include <type_traits>

#include "tracer/scene/object.h"
#include "tracer/shapes/intersections.h"

namespace verisim::shapes::julia {

// Squares, cubes and reciprocals are plain arithmetic. A `cube` of hypercomplex numbers is a square: so it is in
// POV-Ray.
enum class Kind : unsigned char {
  quaternion_square,
  quaternion_cube,
  hypercomplex_square,
  hypercomplex_cube,
  reciprocal,
  function
};
constexpr bool is_quaternion(Kind kind) { return kind == Kind::quaternion_square || kind == Kind::quaternion_cube; }
constexpr bool is_power(Kind kind) { return kind != Kind::reciprocal && kind != Kind::function; }

struct Number {
  double x = 0, y = 0, z = 0, w = 0;
};

// What the iteration needs to know of a fractal.
struct Field {
  Kind kind = Kind::quaternion_square;
  scene::JuliaFunction function = scene::JuliaFunction::sqr;
  Vec2 exponent{0, 0};  // of pwr
  Number parameter;
  Vec3 slice;
  double slice_w = 1, slice_distance = 0;
  double escape = 4;        // |h|^2 beyond which a point is outside
  double precision = 0.05;  // the smallest step
  int iterations = 20;
};

namespace one_point {
using namespace one_ray;
#include "tracer/shapes/julia/julia_formulas.inc"
}  // namespace one_point
using namespace one_point;

// f(h) of Kind::function: f of the two complex numbers that h stands for.
Number image_by_function(const Field& f, const Number& h);

}  // namespace verisim::shapes::julia
