// The three nearest points of a cell in vector instructions.
#pragma once

#include "tracer/math/vec.h"
#include "tracer/textures/patterns/crackle_cells.h"

namespace verisim::textures {

struct NearestThree {
  double s[3];  // ascending sums of squares, or of absolute differences
};
// Eight points: the corners of their cells, the points, and the three smallest distances.
struct CrackleEight {
  alignas(64) double cell[3][8], point[3][8], s[3][8];
};
struct CrackleKernels {
  NearestThree (*squares)(const CrackleCell& cell, const Vec3& p);
  NearestThree (*sums)(const CrackleCell& cell, const Vec3& p);
  // Finds the cells of points with coordinates below 1e9. False: they are not all in one cell.
  bool (*locate)(const double* x, const double* y, const double* z, CrackleEight& at);
  void (*squares_of_eight)(const CrackleCell& cell, CrackleEight& at);
  void (*sums_of_eight)(const CrackleCell& cell, CrackleEight& at);
  // The pattern's values from the distances of eight points: by metric 2 (`roots`) or 1.
  void (*in_form)(const CrackleEight& at, const double* form, double offset, bool roots, double* values);
  // Of points relative to the cell's corner: at_least[i], how near point i can be to a place in the cell. Returns the
  // distance within which three points are from every place.
  double (*bound_squares)(const CrackleCell& cell, double* at_least);
  double (*bound_sums)(const CrackleCell& cell, double* at_least);
};
// Those of the best instruction set of this machine; of any set, for tests; null: this machine cannot run it.
const CrackleKernels& crackle_kernels();
const CrackleKernels* crackle_kernels(int instruction_set);

}  // namespace verisim::textures
