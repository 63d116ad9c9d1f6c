// Four-dimensional numbers of julia_fractal: quaternions and the commutative hypercomplex numbers (spec 04 section 8).
#pragma once

#include <array>

#include "tracer/scene/object.h"

namespace verisim::shapes::julia {

struct Number {
  double x = 0, y = 0, z = 0, w = 0;
  // Summed in this order, as measured: on the bounding sphere the last bit decides whether a point escapes.
  double norm2() const { return x * x + (y * y + z * z + w * w); }
  // That of hypercomplex squares.
  double norm2_by_pairs() const { return (x * x + w * w) + (y * y + z * z); }
  // The order for hypercomplex numbers otherwise, and for products of quaternions.
  double norm2_from_left() const { return x * x + y * y + z * z + w * w; }
};
inline Number operator+(const Number& a, const Number& b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }

// Quaternion functions.
inline Number quaternion_square(const Number& h) {
  const double q = h.y * h.y + h.z * h.z + h.w * h.w, t = 2 * h.x;
  return {h.x * h.x - q, t * h.y, t * h.z, t * h.w};
}
inline Number quaternion_cube(const Number& h) {
  const double q = h.y * h.y + h.z * h.z + h.w * h.w, x2 = h.x * h.x, t = 3 * x2 - q;
  return {h.x * (x2 - 3 * q), h.y * t, h.z * t, h.w * t};
}
// Terms in POV-Ray's order: the last bit of its length decides how far a ray goes (spec 08 M).
inline Number quaternion_product(const Number& a, const Number& b) {
  return {a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w, a.y * b.x + a.x * b.y + a.z * b.w - a.w * b.z,
          a.z * b.x + a.x * b.z + a.w * b.y - a.y * b.w, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y};
}

inline Number product(const Number& a, const Number& b) {
  return {a.x * b.x - a.y * b.y - a.z * b.z + a.w * b.w, a.y * b.x + a.x * b.y - a.w * b.z - a.z * b.w,
          a.z * b.x - a.w * b.y + a.x * b.z - a.y * b.w, a.w * b.x + a.z * b.y + a.y * b.z + a.x * b.w};
}
// The two squares of POV-Ray: that of `sqr`, and that of `cube`, which is no cube (spec 08 M).
inline Number hypercomplex_square(const Number& h) {
  return {(h.x * h.x + h.w * h.w) - (h.y * h.y + h.z * h.z), 2 * (h.x * h.y - h.z * h.w), 2 * (h.x * h.z - h.y * h.w),
          2 * (h.x * h.w + h.y * h.z)};
}
inline Number hypercomplex_cube(const Number& h) {
  return {h.x * h.x - h.y * h.y - h.z * h.z + h.w * h.w, 2 * (h.x * h.y - h.z * h.w), 2 * (h.x * h.z - h.y * h.w),
          2 * (h.x * h.w + h.y * h.z)};
}
Number reciprocal(const Number& h);
// f of the two complex numbers a hypercomplex number stands for. `cube` is the square: so it is in POV-Ray.
Number apply(scene::JuliaFunction f, const Vec2& exponent, const Number& h);

}  // namespace verisim::shapes::julia
