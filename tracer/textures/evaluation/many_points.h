// Patterns at many points at once, as functions of SDL are asked for them.
#pragma once

#include "tracer/textures/texture.h"

namespace verisim::textures {

// The values at any number of points, as `evaluate` gives them one by one. Coordinate i of point k is points[i * stride
// + k].
void evaluate(const CompiledPattern& pattern, const double* points, std::size_t stride, std::size_t count,
              double* values);

}  // namespace verisim::textures
