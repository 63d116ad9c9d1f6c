#include "parser/lexer/words.h"

#include <array>

namespace verisim::parser {
namespace {

using enum WordClass;
constexpr WordEntry kWords[] = {
#define WORD(spelling, word_class) {#spelling, Word::spelling, word_class},
#define WORD_AS(spelling, enumerator, word_class) {#spelling, Word::enumerator, word_class},
#define SPELLING(spelling, enumerator, word_class) {#spelling, Word::enumerator, word_class},
#include "parser/lexer/words.inc"
#undef WORD
#undef WORD_AS
#undef SPELLING
};

// Index by Word into kWords (the first spelling).
constexpr auto kByWord = [] {
  std::array<std::uint16_t, std::size(kWords) + 1> index{};
  for (std::size_t i = std::size(kWords); i-- > 0;)
    index[static_cast<std::size_t>(kWords[i].word)] = static_cast<std::uint16_t>(i + 1);
  return index;
}();

const WordEntry* entry(Word word) {
  const std::uint16_t i =
      static_cast<std::size_t>(word) < kByWord.size() ? kByWord[static_cast<std::size_t>(word)] : std::uint16_t{0};
  return i ? &kWords[i - 1] : nullptr;
}

}  // namespace

std::span<const WordEntry> all_words() { return kWords; }

std::string_view spelling(Word word) {
  const WordEntry* e = entry(word);
  return e ? e->text : std::string_view{};
}

WordClass word_class(Word word) {
  const WordEntry* e = entry(word);
  return e ? e->word_class : keyword;
}

bool starts_color(Word word) {
  switch (word) {
    case Word::rgb:
    case Word::rgbf:
    case Word::rgbt:
    case Word::rgbft:
    case Word::srgb:
    case Word::srgbf:
    case Word::srgbt:
    case Word::srgbft:
      return true;
    default:
      return false;
  }
}

}  // namespace verisim::parser
