// The 498 reserved words of SDL (spec 01 section 2). One enumerator a word; a trailing underscore where C++ needs it;
// alternative spellings (colour, colour_map ...) share the enumerator of the first.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace verisim::parser {

enum class Word : std::uint16_t {
  none,  // not a reserved word
#define WORD(spelling, word_class) spelling,
#define WORD_AS(spelling, enumerator, word_class) enumerator,
#define SPELLING(spelling, enumerator, word_class)
#include "parser/lexer/words.inc"
#undef WORD
#undef WORD_AS
#undef SPELLING
};

// How error messages name a word: "float function 'sin'", "color keyword 'rgb'" (spec 01 section 3).
enum class WordClass : std::uint8_t { keyword, float_function, vector_function, string_function, color };

struct WordEntry {
  std::string_view text;
  Word word;
  WordClass word_class;
};

// Every spelling, in alphabetical order.
std::span<const WordEntry> all_words();
// The (first) spelling of a word; empty for Word::none.
std::string_view spelling(Word word);
WordClass word_class(Word word);
// rgb, srgbft and the like: a vector or number behind it is a colour.
bool starts_color(Word word);

}  // namespace verisim::parser
