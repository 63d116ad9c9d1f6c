#include "tracer/math/transform.h"

#include <stdexcept>

#include "tracer/math/constants.h"
#include "tracer/math/matrix_inverse.h"

namespace verisim {
namespace {

Mat4 transposed(const Mat4& a) { return a.transposed(); }

}  // namespace

// The sums of Imath's operator*, in their order, a row of the result at a time, which compilers turn into packets:
// scenes of many copies spend a tenth of their time here.
Mat4 Transform::product(const Mat4& a, const Mat4& b) {
  Mat4 result(Imath::UNINITIALIZED);
  for (int i = 0; i < 4; ++i) {
    const double* const row = a[i];
    double sums[4];
    for (int j = 0; j < 4; ++j) sums[j] = row[0] * b[0][j] + row[1] * b[1][j] + row[2] * b[2][j] + row[3] * b[3][j];
    for (int j = 0; j < 4; ++j) result[i][j] = sums[j];
  }
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
  return {m, transposed(m)};
}

Transform Transform::axis_rotation(const Vec3& axis, double radians) {
  const Vec3 k = normalize(axis);
  const double c = std::cos(radians), s = std::sin(radians), u = 1.0 - c;
  Mat4 m;
  m[0][0] = k.x * k.x + c * (1.0 - k.x * k.x), m[0][1] = k.x * k.y * u + k.z * s, m[0][2] = k.x * k.z * u - k.y * s;
  m[1][0] = k.x * k.y * u - k.z * s, m[1][1] = k.y * k.y + c * (1.0 - k.y * k.y), m[1][2] = k.y * k.z * u + k.x * s;
  m[2][0] = k.x * k.z * u + k.y * s, m[2][1] = k.y * k.z * u - k.x * s, m[2][2] = k.z * k.z + c * (1.0 - k.z * k.z);
  return {m, transposed(m)};
}

Transform Transform::from_matrix(const Mat4& matrix) {
  const MatrixInverse inverse = cofactor_inverse(matrix);
  if (inverse.determinant == 0) throw std::domain_error("Singular matrix");
  return {matrix, inverse.matrix};
}

bool Transform::is_identity() const { return m == Mat4(); }

}  // namespace verisim
