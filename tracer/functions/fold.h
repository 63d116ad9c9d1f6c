// POV-Ray's constant folding of user functions, with its bug (spec 01 23.5).
#pragma once

#include "tracer/functions/expression.h"

namespace verisim::functions {

// Simplifies every chain below `node` as POV-Ray does when a function is declared. Afterwards chains are to be
// evaluated left to right.
void fold(Node& node);

// A number that POV-Ray regards as a literal: a constant that is not in parentheses.
bool is_literal(const Node& node);

}  // namespace verisim::functions
