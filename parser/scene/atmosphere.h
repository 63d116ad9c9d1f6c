// background { ... }; fog, rainbow and sky_sphere are in blocks.h.
#pragma once

#include "parser/language/blocks.h"

namespace verisim::parser {

Color parse_background(Parser& parser);

}  // namespace verisim::parser
