// The inverse of a 4x4 matrix with POV-Ray's rounding (spec 03 1).
#pragma once

#include "tracer/math/vec.h"

namespace verisim {

struct MatrixInverse {
  Mat4 matrix;
  double determinant;  // 0: there is none
};

// By cofactors of six products each, divided by the determinant, which is that of the first row.
inline MatrixInverse cofactor_inverse(const Mat4& m) {
  const auto cofactor = [&m](int row, int column) {
    const auto at = [&](int i, int k) { return m[i + (i >= row)][k + (k >= column)]; };
    const double minor = at(0, 0) * at(1, 1) * at(2, 2) + at(0, 1) * at(1, 2) * at(2, 0) +
                         at(0, 2) * at(1, 0) * at(2, 1) - at(2, 0) * at(1, 1) * at(0, 2) -
                         at(2, 1) * at(1, 2) * at(0, 0) - at(2, 2) * at(1, 0) * at(0, 1);
    return (row + column) % 2 != 0 ? -minor : minor;
  };
  double determinant = m[0][0] * cofactor(0, 0);
  for (int k = 1; k < 4; ++k) determinant += m[0][k] * cofactor(0, k);
  Mat4 result(Imath::UNINITIALIZED);
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) result[i][k] = cofactor(k, i) / determinant;
  return {result, determinant};
}

}  // namespace verisim
