// Advice for messages: what a misspelt name may have meant, which installed include declares it.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace verisim::parser {

// ASCII letters in lower case.
std::string lowered(std::string_view text);
// Restricted Damerau-Levenshtein distance (swapped neighbours count 1), stopped at `limit` + 1. Letter case counts
// half.
int edit_distance(std::string_view a, std::string_view b, int limit);
// The candidate nearest to `name`, if it is near enough to be likely; else empty.
std::string_view nearest(std::string_view name, std::span<const std::string_view> candidates);
// What a word behind '#' that is no directive was meant to be; `directive` is empty: nobody knows.
struct MeantDirective {
  enum class Why { near, case_, foreign };  // misspelt; not in lower case; of another language
  std::string_view directive;
  Why why = Why::near;
  bool certain = false;
  bool opens = false;  // something that ends at #end
};
MeantDirective meant_directive(std::string_view word);
// The names of the *.inc files below `folders` that declare `name` at the start of a #declare or #macro. Reads at most
// 64 MB.
std::vector<std::string> includes_that_declare(std::string_view name, std::span<const std::filesystem::path> folders);
// True for the names of POV-Ray's standard includes, which come with the package povray-includes.
bool is_standard_include(std::string_view name);

}  // namespace verisim::parser
