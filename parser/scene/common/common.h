// Small helpers that the readers of blocks share.
#pragma once

#include <string>
#include <string_view>

#include "parser/language/blocks.h"

namespace verisim::parser {

// The reserved word at the cursor; Word::none for anything else.
inline Word word_at(Parser& parser) { return parser.peek().word; }

// Consumes a keyword that is known to be at the cursor and the brace after it.
void open_block(Parser& parser);
// The closing brace of the block under way; an error names the block, where it was opened, and what stands there
// instead.
void close_block(Parser& parser);
// "Keyword 'word' can only be used in a WHERE statement."
[[noreturn]] void error_only_in(Parser& parser, Word word, std::string_view where);
// True where a colour starts that needs no further keyword: a colour keyword or an identifier that holds a colour.
bool at_color(Parser& parser);
// A function block or a number follows an optional comma.
bool accept_comma_or_number(Parser& parser);

float to_float(double value);

// Checks that a list of `count` items (untrusted) can be stored, before memory is taken for it.
std::size_t checked_count(Parser& parser, double count, std::string_view what, std::size_t item_bytes);

// Guards a block against endless nesting and remembers where it was opened.
struct Block {
  explicit Block(Parser& p) : parser(p), depth(p), place(p.place()) { open_block(p); }
  void close() { close_block(parser); }
  Parser& parser;
  Parser::Depth depth;
  scene::SourceLocation place;
};
// What `read` makes of all that stands between braces.
template <class Read>
auto in_block(Parser& parser, const Read& read) {
  Block block(parser);
  auto result = read();
  block.close();
  return result;
}

}  // namespace verisim::parser
