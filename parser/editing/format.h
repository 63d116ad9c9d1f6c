// Lays a scene out: indentation by blocks and directives, one blank before a brace, no blanks at the ends of lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/editing/index.h"

namespace verisim::parser {

struct Layout {
  int width = 2;      // blanks a level
  bool tabs = false;  // a tab a level instead
};

struct TextEdit {
  TextRange range;  // of the old text
  std::string text;
};

// What must change, in the order of the text. Only blanks between tokens do: the tokens stay the same (that is checked;
// nothing is changed where they would not), comments keep their text, and formatting the result changes nothing. A file
// that cannot be read to its end is left as it is.
std::vector<TextEdit> format_edits(std::string_view text, const Layout& layout);
std::string applied(std::string_view text, const std::vector<TextEdit>& edits);

}  // namespace verisim::parser
