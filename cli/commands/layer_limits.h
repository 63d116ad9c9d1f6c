// `--layer LAYER:LIMITS` of the commands that compare pictures.
#pragma once

#include <string>
#include <vector>

#include "compare/layers/layers.h"

namespace verisim::cli {

// Throws OptionError.
std::vector<compare::LayerRule> layer_options(const std::vector<std::string>& given);

}  // namespace verisim::cli
