#include "parser/lexer/directive_links.h"

namespace verisim::parser {
bool is_alternative(Word word) {
  return word == Word::else_ || word == Word::elseif || word == Word::case_ || word == Word::range;
}

bool opens_construct(Word word) {
  switch (word) {
    case Word::if_:
    case Word::ifdef:
    case Word::ifndef:
    case Word::while_:
    case Word::for_:
    case Word::switch_:
    case Word::macro:
      return true;
    default:
      return false;
  }
}

bool is_directive(Word word) {
  switch (word) {
    case Word::break_:
    case Word::case_:
    case Word::debug:
    case Word::declare:
    case Word::default_:
    case Word::else_:
    case Word::elseif:
    case Word::end:
    case Word::error:
    case Word::fclose:
    case Word::fopen:
    case Word::for_:
    case Word::if_:
    case Word::ifdef:
    case Word::ifndef:
    case Word::include:
    case Word::local:
    case Word::macro:
    case Word::range:
    case Word::read:
    case Word::render:
    case Word::statistics:
    case Word::switch_:
    case Word::undef:
    case Word::version:
    case Word::warning:
    case Word::while_:
    case Word::write:
      return true;
    default:
      return false;
  }
}

std::vector<std::uint32_t> link_directives(Tokens& tokens) {
  struct Open {
    std::uint32_t last;  // the token that waits for its link
    Word word;
    bool branches;
  };
  std::vector<std::uint32_t> strays;
  std::vector<Open> stack;
  const auto link = [&tokens](std::uint32_t from, std::uint32_t to) {
    tokens[from].payload = (tokens[from].payload & 0xffffffffu) | (std::uint64_t{to} << 32);
  };
  for (std::uint32_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != TokenKind::directive) continue;
    const Word word = tokens[i].word;
    if (opens_construct(word)) {
      stack.push_back({i, word, word != Word::while_ && word != Word::for_ && word != Word::macro});
    } else if (stack.empty()) {
      continue;
    } else if (is_alternative(word) && stack.back().branches) {
      link(stack.back().last, i);
      stack.back().last = i;
    } else if (is_alternative(word) && stack.back().word == Word::macro) {
      strays.push_back(i);
    } else if (word == Word::end) {
      link(stack.back().last, i);
      stack.pop_back();
    }
  }
  return strays;
}

}  // namespace verisim::parser
