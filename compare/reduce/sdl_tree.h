// A scene's text as a tree for cutting: statements, their parts, and the blocks within those.
//
// This reads nothing but words and brackets, and does not know what they mean: what is cut wrongly both programs
// refuse, and nothing is learnt from it. A directive with its #end is one statement, whose branches are blocks.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/editing/format.h"

namespace verisim::compare {

using parser::TextEdit;
using parser::TextRange;

struct SdlBlock;

// A word with what belongs to it: `rotate 30*y`, `pigment { ... }`, `#if (A) ... #else ... #end`.
struct SdlPart {
  TextRange range;
  std::vector<SdlBlock> blocks;
};

struct SdlStatement {
  TextRange range;
  std::vector<SdlPart> parts;
  parser::Word word = parser::Word::none;  // the first one, or that of a directive
  bool directive = false;
};

struct SdlBlock {
  char bracket = 0;  // '{', '[' or '#' (of a directive); 0: the whole text
  TextRange inside;
  std::vector<SdlStatement> statements;
};

// Nothing where brackets do not match, or the text cannot be read to its end.
std::optional<SdlBlock> sdl_tree(std::string_view text);

// Without comments and blank lines: the same tokens. A text that cannot be read is left as it is.
std::string stripped(std::string_view text);
// The same with a statement a line, indented.
std::string laid_out(const std::string& text);

}  // namespace verisim::compare
