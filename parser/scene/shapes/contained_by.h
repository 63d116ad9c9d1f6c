// contained_by { box { ... } | sphere { ... } } of isosurface and parametric.
#pragma once

#include "parser/language/blocks.h"

namespace verisim::parser {

void parse_contained_by(Parser& parser, scene::Contained& container);

}  // namespace verisim::parser
