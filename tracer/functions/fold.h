// POV-Ray's constant folding of user functions, with its bug (spec 01 23.5).
#pragma once

#include "tracer/functions/expression.h"
#include "tracer/functions/operations.h"

namespace verisim::functions {

// Simplifies every chain below `node` as POV-Ray does when a function is declared. Afterwards chains are to be
// evaluated left to right.
void fold(Node& node);

// What an operator is to the register machine.
inline Code code_of(Op op) { return static_cast<Code>(static_cast<int>(Code::add) + static_cast<int>(op)); }
static_assert(static_cast<int>(Op::logic_or) == static_cast<int>(Code::logic_or) - static_cast<int>(Code::add));

// A number that POV-Ray regards as a literal: a constant that is not in parentheses.
bool is_literal(const Node& node);

}  // namespace verisim::functions
