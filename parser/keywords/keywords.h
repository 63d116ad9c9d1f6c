// The one description of SDL's words: where each may stand, what it takes, what holds without it, and what it does.
// Hover, completion, `verisim help WORD`, docs/language and the grammar for highlighting are made from it; a test asks
// the parser, for every word and place, whether that is true (keywords_test.cpp).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace verisim::parser {

// One use of a word; a word that means several things has several, side by side.
struct Keyword {
  std::string_view word;
  // Where it may stand, separated by blanks: names of blocks ("finish"), "scene" (between statements), "value" (behind
  // `#declare NAME =`), "#" (a directive), "expression"; "+word": directly behind that word; "@name": a group of
  // places.
  std::string_view places;
  std::string_view syntax;    // with the word; "[ ]" may be left out, "..." may be repeated, capitals are values
  std::string_view fallback;  // what holds where it is not written; empty: nothing to say
  std::string_view meaning;
};

// Whether a table describes a word. `name`: an enumerator of Word, with an underscore behind it where C++ has the word.
constexpr bool describes(std::span<const Keyword> table, std::string_view name) {
  const std::string_view word = name.substr(0, name.size() - (name.ends_with('_') ? 1 : 0));
  for (const Keyword& keyword : table)
    if (keyword.word == word) return true;
  return false;
}

struct KeywordSection {
  std::string_view title;
  std::string_view name;     // of its page's heading and pictures: "shapes"
  std::string_view opening;  // a paragraph about them
  std::span<const Keyword> keywords;
};

std::span<const KeywordSection> keyword_sections();
// Every use of a word, in the order of the table; empty: SDL has no such word.
std::vector<const Keyword*> keyword_uses(std::string_view word);
// The places with the groups written out.
std::vector<std::string_view> places_of(const Keyword& keyword);
bool may_stand(const Keyword& keyword, std::string_view place);
// All places but those that begin with '+'.
const std::vector<std::string_view>& all_places();

// What `verisim help WORD` prints; what editors show, as Markdown. Empty: no such word. `place`: of several uses only
// those that may stand there, if there are any; empty: all.
std::string keyword_text(std::string_view word);
std::string keyword_markdown(std::string_view word, std::string_view place = {});
// The whole reference as one page of Markdown.
std::string language_page();
// A TextMate grammar (JSON) that colours SDL in editors.
std::string text_mate_grammar();

// The sections, each in a file of its name.
extern const KeywordSection kDirectives, kFunctions, kShapes, kModifiers, kTextures, kPatterns, kImages, kLights,
    kAtmosphere, kCamera, kSettings;

}  // namespace verisim::parser
