// Which bytes blanks, names and numbers are made of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace verisim::parser {

enum CharClass : std::uint8_t { other_class, blank_class, letter_class, digit_class, punctuation_class };

inline constexpr auto kClass = [] {
  std::array<CharClass, 256> table{};
  for (const char c : {' ', '\t', '\v', '\f', '\r', '\n', '\0', '\x1a'})
    table[static_cast<unsigned char>(c)] = blank_class;
  for (int c = 'a'; c <= 'z'; ++c) table[static_cast<std::size_t>(c)] = letter_class;
  for (int c = 'A'; c <= 'Z'; ++c) table[static_cast<std::size_t>(c)] = letter_class;
  table['_'] = letter_class;
  for (int c = '0'; c <= '9'; ++c) table[static_cast<std::size_t>(c)] = digit_class;
  for (const char c : {'{', '}', '(', ')', '[', ']', '<', '>', ',',  ';', ':', '?', '=',  '+', '-',
                       '*', '/', '&', '|', '!', '#', '@', '`', '\\', '$', '^', '%', '\'', '~', '.'})
    table[static_cast<unsigned char>(c)] = punctuation_class;
  return table;
}();

inline CharClass class_of(char c) { return kClass[static_cast<unsigned char>(c)]; }
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace verisim::parser
