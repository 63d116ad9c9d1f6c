#include "tracer/math/transform.h"

#include <stdexcept>

#include "tracer/math/constants.h"
#include "tracer/math/matrix_inverse.h"

namespace verisim {
namespace {

Mat4 transposed(const Mat4& a) { return a.transposed(); }

}  // namespace

Affine::Affine(const Mat4& m) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) (*this)[i][j] = m[i][j];
  at_[12] = m[3][3];
}

Mat4 Affine::whole() const {
  Mat4 m;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) m[i][j] = (*this)[i][j];
  m[3][3] = at_[12];
  return m;
}

// The sums of the product of the whole matrices, in their order, a row of the result at a time, which compilers turn
// into packets: scenes of many copies spend a tenth of their time here. What stands behind a row is read and written,
// too; the next one takes its place.
Affine Transform::product(const Affine& a, const Affine& b) {
  Affine result;
  const double *const b0 = b[0], *const b1 = b[1], *const b2 = b[2], *const b3 = b[3];
  for (int i = 0; i < 4; ++i) {
    const double* const row = a[i];
    const double last = i == 3 ? a.at_[12] : 0;
    double sums[4];
    for (int j = 0; j < 4; ++j) sums[j] = row[0] * b0[j] + row[1] * b1[j] + row[2] * b2[j] + last * b3[j];
    for (int j = 0; j < 4; ++j) result[i][j] = sums[j];
  }
  result.at_[12] = a.at_[12] * b.at_[12];
  return result;
}

Transform Transform::translation(const Vec3& v) {
  Transform t;
  t.m[3][0] = v.x, t.m[3][1] = v.y, t.m[3][2] = v.z;
  t.inv[3][0] = -v.x, t.inv[3][1] = -v.y, t.inv[3][2] = -v.z;
  return t;
}

Transform Transform::scaling(const Vec3& s) {
  Transform t;
  for (int i = 0; i < 3; ++i) t.m[i][i] = s[i], t.inv[i][i] = 1.0 / s[i];
  return t;
}

namespace {

// A turn about one axis.
Mat4 turn(int axis, double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  Mat4 m;
  m[i][i] = m[j][j] = c, m[i][j] = s, m[j][i] = -s;
  return m;
}

}  // namespace

Transform Transform::rotation(const Vec3& degrees) {
  const Vec3 a = degrees * kDegree;
  // The product of the turns about x, y and z; those by nothing are left out.
  Mat4 m;
  bool turned = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (a[axis] == 0) continue;
    m = turned ? m * turn(axis, a[axis]) : turn(axis, a[axis]);
    turned = true;
  }
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) m[i][j] += 0.0;  // no negative zeros, as in the whole product
  return {Affine(m), Affine(transposed(m))};
}

namespace {

// Sets the rows of the rotation.
template <class Matrix>
void rotate_about(const Vec3& axis, double radians, Matrix& m) {
  const Vec3 k = normalize(axis);
  const double c = std::cos(radians), s = std::sin(radians), u = 1.0 - c;
  m[0][0] = k.x * k.x + c * (1.0 - k.x * k.x), m[0][1] = k.x * k.y * u + k.z * s, m[0][2] = k.x * k.z * u - k.y * s;
  m[1][0] = k.x * k.y * u - k.z * s, m[1][1] = k.y * k.y + c * (1.0 - k.y * k.y), m[1][2] = k.y * k.z * u + k.x * s;
  m[2][0] = k.x * k.z * u + k.y * s, m[2][1] = k.y * k.z * u - k.x * s, m[2][2] = k.z * k.z + c * (1.0 - k.z * k.z);
}

}  // namespace

Transform Transform::axis_rotation(const Vec3& axis, double radians) {
  Mat4 m;
  rotate_about(axis, radians, m);
  return {Affine(m), Affine(transposed(m))};
}

Vec3 Transform::rotated(const Vec3& d, const Vec3& axis, double radians) {
  Affine m;
  rotate_about(axis, radians, m);
  return apply_direction(m, d);
}

Transform Transform::from_matrix(const Mat4& matrix) {
  const MatrixInverse inverse = cofactor_inverse(matrix);
  if (inverse.determinant == 0) throw std::domain_error("Singular matrix");
  return {Affine(matrix), Affine(inverse.matrix)};
}

bool Transform::is_identity() const { return m == Affine(); }

}  // namespace verisim
