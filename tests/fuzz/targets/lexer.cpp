#include "tests/fuzz/targets.h"

#include <memory>

#include "parser/lexer/lexer.h"
#include "tests/fuzz/promise.h"

namespace verisim::fuzz {

using namespace parser;

void lexer(std::string_view bytes) {
  // Words of the language are hundreds, and were most of the work: they stay, with the names that came since.
  static std::unique_ptr<Names> known;
  if (!known || known->size() > 10000) known = std::make_unique<Names>();
  Names& names = *known;
  const auto file = tokenise(std::make_shared<Source>("fuzz.pov", bytes), names, 1 << 20, true);
  const Tokens& tokens = file->tokens;
  require(!tokens.empty(), "a last token");
  const TokenKind last = tokens.back().kind;
  require(last == TokenKind::end || last == TokenKind::error, "the last token ends the file or says why it ends");
  std::uint32_t before = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& t = tokens[i];
    require(t.offset <= bytes.size() && t.offset >= before, "tokens follow each other in the text");
    before = t.kind == TokenKind::error ? before : t.offset;
    require(i + 1 == tokens.size() || (t.kind != TokenKind::end && t.kind != TokenKind::error),
            "the end is at the end");
    switch (t.kind) {
      case TokenKind::string:
        require(t.offset + 1 + t.id() <= bytes.size(), "a string lies in the text");
        break;
      case TokenKind::vector:
        require(t.terms() >= 2 && t.terms() <= 5 && t.id() + t.terms() <= file->numbers.size(),
                "a vector has its numbers");
        break;
      case TokenKind::identifier:
        require(t.id() > 0 && t.id() < names.size() && !names[t.id()].text.empty(), "an identifier has a name");
        break;
      case TokenKind::directive:
        require(t.link() == 0 ||
                    (t.link() > i && t.link() < tokens.size() && tokens[t.link()].kind == TokenKind::directive),
                "links lead forward to directives");
        break;
      default:
        break;
    }
  }
}

}  // namespace verisim::fuzz
