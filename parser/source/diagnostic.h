// Messages about a scene: `file:line:column: severity: text`, the source line with a caret, the includes and macro
// calls that led there.
#pragma once

#include <string>
#include <vector>

namespace verisim::parser {

enum class Severity : unsigned char { warning, possible_error, error, unsupported };

struct Diagnostic {
  Severity severity = Severity::error;
  std::string file;
  int line = 0, column = 0;  // 1-based; 0: no place
  std::string message;
  std::string advice;              // "did you mean ...", the package that has a file ...; may be empty
  std::string source_line;         // the text of the line, for the caret; an excerpt of a very long one
  int caret = 0;                   // 1-based column of the caret in source_line; 0: `column`
  std::vector<std::string> trail;  // "included from a.pov:3", "in macro M called at b.inc:7"
};

// Several lines of text for a terminal; colour with ANSI escapes if asked.
std::string format(const Diagnostic& diagnostic, bool color = false);

}  // namespace verisim::parser
