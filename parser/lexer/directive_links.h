// What a directive is, and where the construct it opens goes on.
#pragma once

#include <vector>

#include "parser/lexer/lexer.h"

namespace verisim::parser {

bool is_directive(Word word);
bool opens_construct(Word word);  // that an #end closes
bool is_alternative(Word word);   // #else, #elseif, #case, #range

// Links each opener and alternative to the next alternative or #end of the same construct, so that skipping is a jump.
// What has no partner in this file keeps 0 and is found by scanning. Loops and macros have no alternatives: one inside
// them at their own level means nothing to a skip, but in a macro it is a mistake. Returns those.
std::vector<std::uint32_t> link_directives(Tokens& tokens);

}  // namespace verisim::parser
