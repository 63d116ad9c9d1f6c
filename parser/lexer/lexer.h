// Turns a file into tokens, once (spec 01 section 1). Loops, macros and repeated includes replay ranges of the token
// array.
#pragma once

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "parser/lexer/names.h"
#include "parser/lexer/token.h"
#include "parser/source/source.h"

namespace verisim::parser {

// Why the lexer stopped; kept in the error token and reported only when the cursor gets there.
enum class LexError : std::uint32_t {
  illegal_character,
  unterminated_string,
  newline_after_backslash,
  unterminated_comment,
  second_point,
  too_many_tokens
};
const char* describe(LexError error);

void* allocate_huge(std::size_t bytes);  // from malloc's family; throws std::bad_alloc

// Large arrays of tokens lie in huge pages where the system has them: page faults are a good part of the time a large
// file takes.
template <class T>
struct HugePageAllocator {
  using value_type = T;
  HugePageAllocator() = default;
  template <class U>
  HugePageAllocator(const HugePageAllocator<U>&) {}
  T* allocate(std::size_t count) { return static_cast<T*>(allocate_huge(count * sizeof(T))); }
  void deallocate(T* p, std::size_t) { std::free(p); }
  friend bool operator==(const HugePageAllocator&, const HugePageAllocator&) { return true; }
};
using Tokens = std::vector<Token, HugePageAllocator<Token>>;
using Numbers = std::vector<double, HugePageAllocator<double>>;

struct TokenFile : std::enable_shared_from_this<TokenFile> {
  std::shared_ptr<const Source> source;
  Tokens tokens;    // the last one has kind end or error
  Numbers numbers;  // of literal vectors
  // #else, #elseif, #case and #range directly within a #macro: an error wherever the macro is read or passed over.
  std::vector<std::uint32_t> stray_branches;
  bool starts_with_high_bytes = false;

  const double* vector(const Token& token) const { return numbers.data() + token.id(); }
  // Where the '#' is that stands before a token with nothing but blanks between; npos: there is none.
  std::size_t hash_before(const Token& token) const;
  // Bytes of a token as it is written, from its offset on; 0 at the end of the file.
  std::size_t length(const Token& token) const;
  // The bytes between the quotes of a string token, escapes untouched.
  std::string_view raw_string(const Token& token) const { return source->text().substr(token.offset + 1, token.id()); }
};

// `main_file`: leading bytes >= 0x80 are dropped (spec 01 1.1). Never throws for bad input; stops with an error token.
std::shared_ptr<const TokenFile> tokenise(std::shared_ptr<const Source> source, Names& names, std::size_t max_tokens,
                                          bool main_file = false);

}  // namespace verisim::parser
