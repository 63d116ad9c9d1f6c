// Where the tokens of a file are in its text.
#include <new>

#include "parser/lexer/lexer.h"
#include "parser/lexer/number.h"
#include "tracer/base/huge_pages.h"

namespace verisim::parser {

void* allocate_huge(std::size_t bytes) {
  void* const p = std::malloc(bytes);
  if (!p) throw std::bad_alloc();
  fill_by_huge_pages(p, bytes);
  return p;
}

std::size_t TokenFile::length(const Token& token) const {
  const std::string_view rest = source->text().substr(token.offset);
  const auto name_from = [&](std::size_t i) {
    while (i < rest.size() && (class_of(rest[i]) == letter_class || class_of(rest[i]) == digit_class)) ++i;
    return i;
  };
  switch (token.kind) {
    case TokenKind::end:
      return 0;
    case TokenKind::error:
      return rest.empty() ? 0 : 1;
    case TokenKind::punctuation:
      return token.punctuation == kLessEqual || token.punctuation == kGreaterEqual || token.punctuation == kNotEqual
                 ? 2
                 : 1;
    case TokenKind::word:
    case TokenKind::identifier:
      return name_from(0);
    case TokenKind::directive: {
      std::size_t i = 1;
      while (i < rest.size() && class_of(rest[i]) == blank_class) ++i;
      return name_from(i);
    }
    case TokenKind::number: {
      const char* p = rest.data();
      double value;
      read_number(p, value);
      return static_cast<std::size_t>(p - rest.data());
    }
    case TokenKind::string:
      return token.id() + std::size_t{2};
    case TokenKind::vector:
      break;
  }
  // A literal vector may have comments inside.
  for (std::size_t i = 1; i < rest.size(); ++i) {
    if (rest[i] == '>') return i + 1;
    if (rest[i] != '/' || i + 1 == rest.size()) continue;
    if (rest[i + 1] == '/') {
      while (i < rest.size() && rest[i] != '\n' && rest[i] != '\r') ++i;
    } else if (rest[i + 1] == '*') {
      int nested = 0;
      do {
        const std::string_view two = rest.substr(i, 2);
        nested += two == "/*" ? 1 : two == "*/" ? -1 : 0;
        i += two == "/*" || two == "*/" ? 2 : 1;
      } while (nested && i < rest.size());
      --i;
    }
  }
  return rest.size();
}

std::size_t TokenFile::hash_before(const Token& token) const {
  const std::string_view text = source->text();
  std::size_t i = token.offset;
  while (i > 0 && (text[i - 1] == ' ' || text[i - 1] == '\t')) --i;
  return i > 0 && text[i - 1] == '#' ? i - 1 : std::string_view::npos;
}

}  // namespace verisim::parser
