// Where in a scene an offset is: in which block, in a comment, in a string. It decides which words may stand there.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/lexer/lexer.h"

namespace verisim::parser {

constexpr std::size_t kMaxTokens = std::size_t{1} << 26;  // of a file in an editor

struct EditPlace {
  enum class In { code, comment, string };
  In in = In::code;
  // As the table of keywords names it: "finish", "scene", "value", "expression"; empty: not to be told (in a macro, a
  // part of any block may stand).
  std::string place;
  std::size_t begin = 0;     // of the string's text, or of the word that is being written
  Word opener = Word::none;  // the word right before: of the string, or before the brace
  bool behind_hash = false, behind_dot = false;
};

// `offset` may be anywhere in the file, its end included. `text`: the file as it is written, where its tokens are those
// of NameIndex, which mends what cannot be read.
EditPlace place_at(const TokenFile& file, std::string_view text, std::size_t offset);

// A comment with its delimiters, as bytes [begin, end).
struct Comment {
  std::size_t begin = 0, end = 0;
};
// All comments, in order; those within literal vectors are left out.
std::vector<Comment> comments_of(const TokenFile& file);

// The token that contains an offset or ends there, identifiers and words first; the last one (kind end) where there is
// none.
const Token& token_at(const TokenFile& file, std::size_t offset);

}  // namespace verisim::parser
