// An affine transformation with its inverse, both built from elementary steps as POV-Ray builds them (spec 03 section
// 1).
#pragma once

#include <span>

#include "tracer/math/vec.h"

namespace verisim {

// A 4x4 matrix whose last column is 0, 0, 0 and a corner, which is 1 but for the rounding of an inverse: it counts in
// products. Of a scene of many copies a tenth is such matrices.
class Affine {
 public:
  Affine() = default;
  explicit Affine(const Mat4& m);

  double* operator[](int row) { return at_ + 3 * row; }  // of three columns
  const double* operator[](int row) const { return at_ + 3 * row; }
  Mat4 whole() const;
  // The numbers, row by row; the corner is the last.
  std::span<const double, 13> numbers() const { return at_; }
  friend bool operator==(const Affine&, const Affine&) = default;

 private:
  friend struct Transform;
  double at_[13] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
};

struct Transform {
  Affine m;    // row-vector convention: p' = p * m
  Affine inv;  // the product of the elementary inverses, not a numerical inversion of m

  static Transform translation(const Vec3& v);
  static Transform scaling(const Vec3& s);  // components must be non-zero (the parser replaces zeros by 1 and warns)
  static Transform rotation(const Vec3& degrees);                    // about x, then y, then z
  static Transform axis_rotation(const Vec3& axis, double radians);  // Rodrigues; axis need not be unit
  // axis_rotation(axis, radians).direction(d)
  static Vec3 rotated(const Vec3& d, const Vec3& axis, double radians);
  static Transform from_matrix(
      const Mat4& matrix);  // inverts numerically (cofactors); throws std::domain_error when singular

  bool is_identity() const;
  Transform inverse() const { return {inv, m}; }
  // This transformation first, then `next`.
  Transform then(const Transform& next) const { return {product(m, next.m), product(next.inv, inv)}; }

  Vec3 point(const Vec3& p) const { return apply_point(m, p); }
  Vec3 inverse_point(const Vec3& p) const { return apply_point(inv, p); }
  Vec3 direction(const Vec3& d) const { return apply_direction(m, d); }
  Vec3 inverse_direction(const Vec3& d) const { return apply_direction(inv, d); }
  // Normals go by the inverse transpose; the result is not normalised.
  Vec3 normal(const Vec3& n) const { return apply_transposed(inv, n); }
  Vec3 inverse_normal(const Vec3& n) const { return apply_transposed(m, n); }

 private:
  static Affine product(const Affine& a, const Affine& b);
  static Vec3 apply_point(const Affine& a, const Vec3& p) {
    return {p.x * a[0][0] + p.y * a[1][0] + p.z * a[2][0] + a[3][0],
            p.x * a[0][1] + p.y * a[1][1] + p.z * a[2][1] + a[3][1],
            p.x * a[0][2] + p.y * a[1][2] + p.z * a[2][2] + a[3][2]};
  }
  static Vec3 apply_direction(const Affine& a, const Vec3& d) {
    return {d.x * a[0][0] + d.y * a[1][0] + d.z * a[2][0], d.x * a[0][1] + d.y * a[1][1] + d.z * a[2][1],
            d.x * a[0][2] + d.y * a[1][2] + d.z * a[2][2]};
  }
  static Vec3 apply_transposed(const Affine& a, const Vec3& n) {
    return {n.x * a[0][0] + n.y * a[0][1] + n.z * a[0][2], n.x * a[1][0] + n.y * a[1][1] + n.z * a[1][2],
            n.x * a[2][0] + n.y * a[2][1] + n.z * a[2][2]};
  }
};

}  // namespace verisim
