// Finds descriptions of the same pattern.
#pragma once

#include <string>

#include "tracer/scene/pattern.h"

namespace verisim::textures {

// Equal for patterns that have the same value everywhere; what they refer to (images, functions, objects) is compared
// by address.
std::string pattern_signature(const scene::Pattern& pattern);

}  // namespace verisim::textures
