// The row "verisimilitude": who is how far from a photograph.
#pragma once

#include <string>

#include "compare/compare.h"

namespace verisim::compare {

// "verisimilitude (mean CIEDE2000): verisim 2.31, povray 2.32, path 1.87: path is nearest"; empty without renderers
// beside ours.
std::string verisimilitude(const SceneResult& scene, const Run& run);

}  // namespace verisim::compare
