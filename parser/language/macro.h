// A macro: a range of tokens that is executed in place of its call (spec 01 section 15).
#pragma once

#include <memory>
#include <vector>

#include "parser/lexer/lexer.h"
#include "parser/language/parser.h"

namespace verisim::parser {

struct Macro {
  static constexpr int kSince = 310;  // version of SDL
  std::uint32_t name = 0;
  std::vector<std::uint32_t> parameters;
  std::shared_ptr<const TokenFile> file;
  std::uint32_t definition = 0;  // the #macro token
  std::uint32_t body = 0;        // first token of the body
  std::uint32_t end = 0;         // its #end
  bool is_expression =
      false;  // short, without directives, braces and strings: it can only be read as part of an expression
};

// Where a macro is defined, where it is called and where it ends the version of the scene must know them.
void require_macros(Parser::Impl& parser);

}  // namespace verisim::parser
