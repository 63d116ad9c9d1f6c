// Internal functions of SDL that are made of noise: noise3d, noise_generator, the multifractals (spec 01 section 24).
#pragma once

#include "tracer/functions/function.h"

namespace verisim::functions {

// The internal function n, which is one of 29, 58, 59, 76 and 78; null for any other number. `noise_generator` (1 to 3)
// is that of the scene, where the function does not choose its own.
FunctionPtr noise_function(int n, int noise_generator);

}  // namespace verisim::functions
