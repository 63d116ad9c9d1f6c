// Interned spellings: every identifier and reserved word gets a number once, so that tokens compare as integers and
// symbols are found by index.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "parser/lexer/words.h"

namespace verisim::parser {

struct Symbol;  // parser/language/symbols.h

struct Name {
  std::string_view text;
  std::uint64_t hash = 0;
  Word word = Word::none;
  Symbol* symbol = nullptr;  // the newest visible symbol of this name; owned by the symbol tables
};

class Names {
 public:
  Names();
  Names(const Names&) = delete;
  Names& operator=(const Names&) = delete;

  std::uint32_t intern(std::string_view text);
  // The number of an already interned text; 0 when unknown.
  std::uint32_t find(std::string_view text) const;
  Name& operator[](std::uint32_t id) { return entries_[id]; }
  const Name& operator[](std::uint32_t id) const { return entries_[id]; }
  std::size_t size() const { return entries_.size(); }

 private:
  std::string_view store(std::string_view text);
  void grow();

  std::vector<Name> entries_;         // entry 0 is "no name"
  std::vector<std::uint32_t> table_;  // open addressing, a power of two long; 0: free
  std::vector<std::unique_ptr<char[]>> chunks_;
  std::size_t chunk_free_ = 0;
  char* chunk_ = nullptr;
};

}  // namespace verisim::parser
