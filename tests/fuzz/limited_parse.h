// Scenes of fuzzers are read within small limits, and without files.
#pragma once

#include <string>

#include "parser/parse.h"

namespace verisim::fuzz {

// A scene, or errors that say why there is none.
parser::ParseResult parse(const std::string& text);

}  // namespace verisim::fuzz
