// How far values of ProgramKernels::approximate may be from those that ProgramKernels::narrow computes, over a box.
// Infinity: not known.
#pragma once

#include "tracer/functions/program.h"
#include "tracer/math/vec.h"

namespace verisim::functions {

double error_bound(const Program& program, const Box3& box);

}  // namespace verisim::functions
