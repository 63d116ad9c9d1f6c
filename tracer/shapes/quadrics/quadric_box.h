// Where a quadric can be solid: its box, by interval arithmetic.
#pragma once

#include "tracer/scene/object.h"

namespace verisim::shapes {

// A conservative box of the points of `known` at which the quadric's value is not above 0; sides may be infinite.
Box3 narrowed(const Box3& known, const scene::Quadric& quadric);

}  // namespace verisim::shapes
