// How far values of LaneKernels::nearly may be from those that LaneKernels::narrow computes, over a box. Infinity: not
// known.
#pragma once

#include "tracer/functions/program.h"
#include "tracer/math/vec.h"

namespace verisim::functions {

double drift(const Program& program, const Box3& box);

}  // namespace verisim::functions
