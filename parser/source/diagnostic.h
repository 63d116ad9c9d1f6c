// Messages about a scene: `file:line:column: severity: text [code]`, the source line with what is meant underlined,
// where what is open began, the includes and macro calls that led there.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/source/codes.h"

namespace verisim::parser {

enum class Severity : unsigned char { warning, possible_error, error, unsupported };

// A piece of text with the line it stands in.
struct Excerpt {
  std::string file;
  int line = 0, column = 0;  // 1-based; 0: no place
  int length = 0;            // bytes underlined; 0: a caret alone
  std::string source_line;   // the text of the line; an excerpt of a very long one
  int caret = 0;             // 1-based column of the place in source_line; 0: `column`
};

// Another place that a message is about: "the block was opened here".
struct Related {
  std::string message;
  Excerpt place;
};

// Replaces bytes of a file. Only where there can be no doubt about what was meant.
struct Fix {
  std::string title;       // "write 'sphere'"
  std::string file;        // as the diagnostic names it
  std::size_t offset = 0;  // first byte
  std::size_t length = 0;  // bytes that are replaced
  std::string text;        // what comes in their place
};

struct Diagnostic : Excerpt {
  Severity severity = Severity::error;
  Code code = Code::internal;
  std::string message;
  std::string advice;  // "did you mean ...", the package that has a file ...; may be empty
  std::vector<Related> related;
  std::optional<Fix> fix;
  std::vector<std::string> trail;  // "included from a.pov:3", "in macro M called at b.inc:7"
};

// Several lines of text for a terminal; colour with ANSI escapes if asked.
std::string format(const Diagnostic& diagnostic, bool color = false);
// Text for one line of a terminal: control characters are shown as '?', tabs as blanks.
std::string printable(std::string_view text);

}  // namespace verisim::parser
