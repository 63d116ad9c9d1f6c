// Small helpers for words of the command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace verisim::cli {

std::string lower(std::string_view text);
bool equal_ignoring_case(std::string_view a, std::string_view b);
bool starts_with_ignoring_case(std::string_view text, std::string_view prefix);
std::string_view trim(std::string_view text);

// The candidate nearest to `word` by edit distance (letters case-blind), or empty if none is near enough to be a slip
// of the finger.
std::string nearest(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace verisim::cli
