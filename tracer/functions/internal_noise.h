#pragma once

#include "tracer/functions/function.h"

namespace verisim::functions {

// The internal functions 29, 58, 59, 76 and 78; null for any other number.
FunctionPtr noise_function(int n, int noise_generator);

}  // namespace verisim::functions
