// Tokens: what a file becomes, once. 16 bytes each; numbers are converted, words and identifiers interned, directives
// linked.
#pragma once

#include <bit>
#include <cstdint>

#include "parser/lexer/words.h"

namespace verisim::parser {

// Two-character operators as punctuation codes (spec 01 section 1.2).
inline constexpr char kLessEqual = '\x01', kGreaterEqual = '\x02', kNotEqual = '\x03';

enum class TokenKind : std::uint8_t {
  end,          // of the file
  error,        // the lexer stopped here (illegal character, unterminated string ...): an error when it is reached
  punctuation,  // `punctuation` is the character or one of the codes above
  word,         // a reserved word
  identifier,
  number,
  string,
  vector,     // < > around 2 to 5 literal numbers with commas, as one token; `punctuation` is '<', the numbers are in
              // TokenFile::numbers
  directive,  // '#' and its word; the cursor executes these, blocks never see them
};

struct Token {
  TokenKind kind = TokenKind::end;
  char punctuation = 0;      // 0 unless kind is punctuation or vector
  Word word = Word::none;    // none unless kind is word or directive
  std::uint32_t offset = 0;  // first byte in the file
  std::uint64_t payload = 0;

  double number() const { return std::bit_cast<double>(payload); }
  // identifier: interned name; string: bytes between the quotes; error: LexError; '[' punctuation: 1 when a comment
  // precedes it.
  std::uint32_t id() const { return static_cast<std::uint32_t>(payload); }
  // vector: how many numbers, and where they start in TokenFile::numbers (id()).
  std::uint32_t terms() const { return static_cast<std::uint32_t>(payload >> 32); }
  // directive: index of the next #else, #elseif, #case, #range or #end of the same construct; 0: not in this file.
  std::uint32_t link() const { return static_cast<std::uint32_t>(payload >> 32); }
};
static_assert(sizeof(Token) == 16);

}  // namespace verisim::parser
