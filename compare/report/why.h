// Why a scene failed, in one sentence with the figure and the limit.
#pragma once

#include <string>

#include "compare/compare.h"

namespace verisim::compare {

// "87.906 % of the pixels are within one code value of the reference; 99.5 % must be." Of what is no figure beyond its
// limit, the reason as it is. Empty for a scene without one.
std::string why(const SceneResult& scene);

}  // namespace verisim::compare
