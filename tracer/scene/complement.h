// Objects that are left out where boxes are cut with each other.
#pragma once

#include "tracer/scene/object.h"

namespace verisim::scene {

// Outside of it all is inside. A julia_fractal's box counts even where its inside is taken away (spec 08 M).
inline bool is_complement(const Object& object) {
  return object.inverted && !object.as<std::shared_ptr<const JuliaFractal>>();
}

}  // namespace verisim::scene
