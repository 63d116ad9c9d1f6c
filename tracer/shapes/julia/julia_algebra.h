// Four-dimensional numbers of julia_fractal: quaternions and the commutative hypercomplex numbers (spec 04 section 8).
#pragma once

#include <array>

#include "tracer/scene/object.h"
#include "tracer/shapes/intersections.h"

namespace verisim::shapes::julia {

// Squares and cubes have formulas of their own.
enum class Kind : unsigned char { quaternion_square, quaternion_cube, hypercomplex_square, hypercomplex_cube, other };
constexpr bool is_quaternion(Kind kind) { return kind == Kind::quaternion_square || kind == Kind::quaternion_cube; }

namespace one_point {
#include "tracer/shapes/julia/julia_formulas.inc"
}  // namespace one_point
using namespace one_point;

struct Number {
  double x = 0, y = 0, z = 0, w = 0;
};

Number reciprocal(const Number& h);
// f of the two complex numbers a hypercomplex number stands for. `cube` is the square: so it is in POV-Ray.
Number apply(scene::JuliaFunction f, const Vec2& exponent, const Number& h);

}  // namespace verisim::shapes::julia
