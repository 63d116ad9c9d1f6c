// Pixels that a scene's manifest leaves out of the comparison.
#pragma once

#include "compare/compare.h"

namespace verisim::compare {

// Makes both pictures black there; one byte a pixel of what was ignored is returned. `tags` are needed where objects
// are named. Throws std::runtime_error for a mask that cannot be read or has another size, and when nothing says which
// pixels show an object.
std::vector<unsigned char> ignore_pixels(const Ignored& ignored, const PixelTags* tags, Picture& reference,
                                         Picture& test);

}  // namespace verisim::compare
