#include "tests/fuzz/sdl_mutator.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <random>
#include <vector>

#include "parser/keywords/keywords.h"

namespace verisim::fuzz {
namespace {

using Tokens = std::vector<std::string>;

constexpr std::string_view kNumbers[] = {"0",     "-0",     "1",    "-1",   "2",    "0.5",        "1e-30", "1e30",
                                         "1e300", "-1e300", "1e10", "1e-9", "1000", "2147483648", "255",   "3.7"};
constexpr std::size_t kLargest = 1 << 16;  // of a scene, in tokens: doubled blocks grow without end

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '#'; }
bool is_number(const std::string& token) {
  return std::isdigit(static_cast<unsigned char>(token[0])) || (token[0] == '.' && token.size() > 1);
}

std::size_t end_of_token(std::string_view text, std::size_t at) {
  const char first = text[at++];
  if (first == '"') {
    while (at < text.size() && text[at] != '"') at += text[at] == '\\' ? 2 : 1;
    return std::min(at + 1, text.size());
  }
  const bool digits = std::isdigit(static_cast<unsigned char>(first)) || first == '.';
  if (!digits && !is_word(first)) return at;
  while (at < text.size() && (is_word(text[at]) || (digits && text[at] == '.'))) ++at;
  return at;
}

// Words, numbers, strings and signs; blanks are made anew.
Tokens tokens_of(std::string_view text) {
  Tokens tokens;
  for (std::size_t at = 0; at < text.size() && tokens.size() < kLargest;) {
    const std::size_t end = end_of_token(text, at);
    if (!std::isspace(static_cast<unsigned char>(text[at]))) tokens.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return tokens;
}

std::string joined(const Tokens& tokens) {
  std::string text;
  for (const std::string& token : tokens) text += token + (token == "}" || token == ";" ? "\n" : " ");
  return text;
}

// From a token on: a block with the word before it, or one token.
struct Range {
  std::size_t begin, end;
};

Range block_at(const Tokens& tokens, std::size_t open) {
  std::size_t end = open, depth = 0;
  do {
    if (tokens[end] == "{") ++depth;
    if (tokens[end] == "}") --depth;
    ++end;
  } while (end < tokens.size() && depth > 0);
  return {open > 0 ? open - 1 : open, end};
}

class Mutator {
 public:
  Mutator(std::string_view scene, std::string_view other, std::uint32_t seed)
      : random_(seed), tokens_(tokens_of(scene)), other_(tokens_of(other)) {}

  std::string run() {
    for (std::size_t changes = 1 + below(4); changes > 0 && !tokens_.empty(); --changes) change();
    return joined(tokens_);
  }

 private:
  std::size_t below(std::size_t n) { return n ? random_() % n : 0; }

  // The word before the innermost block around a token: "" outside of all.
  std::string place_of(std::size_t at) const {
    for (std::size_t depth = 0; at-- > 0;) {
      if (tokens_[at] == "}") ++depth;
      if (tokens_[at] == "{" && depth-- == 0) return at > 0 ? tokens_[at - 1] : "";
    }
    return "scene";
  }

  Range some_block(const Tokens& tokens) {
    if (tokens.empty()) return {0, 0};
    const std::size_t from = below(tokens.size());
    const auto open = std::find(tokens.begin() + static_cast<std::ptrdiff_t>(from), tokens.end(), "{");
    if (open == tokens.end()) return {from, from + 1};
    return block_at(tokens, static_cast<std::size_t>(open - tokens.begin()));
  }

  static Tokens part(const Tokens& tokens, Range r) {
    return {tokens.begin() + static_cast<std::ptrdiff_t>(r.begin), tokens.begin() + static_cast<std::ptrdiff_t>(r.end)};
  }
  void replace(Range r, const Tokens& with) {
    if (tokens_.size() + with.size() > kLargest) return;
    const auto at = tokens_.erase(tokens_.begin() + static_cast<std::ptrdiff_t>(r.begin),
                                  tokens_.begin() + static_cast<std::ptrdiff_t>(r.end));
    tokens_.insert(at, with.begin(), with.end());
  }
  void insert(std::size_t at, const Tokens& what) { replace({at, at}, what); }

  // A use of a word that may stand in the block around a token, as its table writes it.
  Tokens fitting_words(std::size_t at) {
    const std::string place = place_of(at);
    const auto sections = parser::keyword_sections();
    for (int tries = 0; tries < 200; ++tries) {
      const auto keywords = sections[below(sections.size())].keywords;
      const parser::Keyword& use = keywords[below(keywords.size())];
      if (!parser::may_stand(use, place)) continue;
      return tokens_of(use.syntax);
    }
    return {};
  }

  // What the table calls A, COLOR, V ... becomes a number.
  void fill(Tokens& words) {
    for (std::string& word : words)
      if (std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isupper(c); }))
        word = kNumbers[below(std::size(kNumbers))];
  }

  void wrap(Range r) {
    static const Tokens kBefore[] = {{"#for", "(", "I", ",", "1", ",", "3", ")"},
                                     {"#if", "(", "1", ")"},
                                     {"union", "{"},
                                     {"difference", "{"},
                                     {"#macro", "M", "(", "A", ")"}};
    static const Tokens kAfter[] = {
        {"#end"}, {"#end"}, {"}"}, {"sphere", "{", "0", ",", "1", "}", "}"}, {"#end", "M", "(", "1", ")"}};
    const std::size_t kind = below(std::size(kBefore));
    insert(r.end, kAfter[kind]);
    insert(r.begin, kBefore[kind]);
  }

  void change() {
    const std::size_t at = below(tokens_.size());
    switch (below(9)) {
      case 0:
        return replace({at, at + 1}, {});
      case 1:
        return replace(some_block(tokens_), {});
      case 2:
        return insert(at, part(tokens_, some_block(tokens_)));
      case 3:
        return insert(at, part(other_, some_block(other_)));
      case 4:
        return replace(some_block(tokens_), part(other_, some_block(other_)));
      case 5:
        return wrap(some_block(tokens_));
      case 6: {
        Tokens words = fitting_words(at);
        fill(words);
        return insert(at, words);
      }
      case 7: {
        const auto number = std::find_if(tokens_.begin() + static_cast<std::ptrdiff_t>(at), tokens_.end(), is_number);
        if (number != tokens_.end()) *number = kNumbers[below(std::size(kNumbers))];
        return;
      }
      default:
        std::swap(tokens_[at], tokens_[below(tokens_.size())]);
    }
  }

  std::minstd_rand random_;
  Tokens tokens_, other_;
};

}  // namespace

std::string mutate_scene(std::string_view scene, std::string_view other, std::uint32_t seed) {
  return Mutator(scene, other, seed).run();
}

}  // namespace verisim::fuzz
