// The three nearest points of a cell in vector instructions.
#pragma once

#include "tracer/math/vec.h"
#include "tracer/textures/instruction_sets.h"
#include "tracer/textures/patterns/crackle_cells.h"

namespace verisim::textures {

struct NearestThree {
  double s[3];  // ascending sums of squares, or of absolute differences
};
struct CrackleKernels {
  NearestThree (*squares)(const CrackleCell& cell, const Vec3& place);
  NearestThree (*sums)(const CrackleCell& cell, const Vec3& place);
  // at_least[i]: how near point i can be to a place in the cell. Returns the distance within which three points are from every place.
  double (*bound_squares)(const CrackleCell& cell, double* at_least);
  double (*bound_sums)(const CrackleCell& cell, double* at_least);
};
// `set` must not be beyond best_instruction_set().
const CrackleKernels& crackle_kernels(InstructionSet set);

}  // namespace verisim::textures
