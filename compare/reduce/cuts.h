// What may be changed in a scene to make it smaller.
#pragma once

#include "compare/reduce/reducer.h"

namespace verisim::compare {

// `depth`: of the blocks that are looked at; the whole text is 0.
std::size_t depth_of(const SdlBlock& tree);

// Each statement left out; a #version at the beginning stays, so that a reader knows the language.
std::vector<Change> statements_left_out(const SdlBlock& tree, std::size_t depth);
// Each word with its values left out.
std::vector<Change> parts_left_out(const SdlBlock& tree, std::size_t depth);
// Each word and its block replaced by what stands in the block: in the last one, of a condition in the one before.
std::vector<Change> contents_of_blocks(const std::string& text, const SdlBlock& tree, std::size_t depth, bool last);
// Loops that run once.
std::vector<Change> loops_once(const std::string& text, const SdlBlock& tree, std::size_t depth);

// How a declared name is replaced by what it means.
enum class Meaning { value, in_parentheses, content };
std::vector<Change> names_replaced(const std::string& text, Meaning meaning);
// Numbers replaced by shorter ones: by `digit`, or (0) by themselves with one digit.
std::vector<Change> numbers_replaced(const std::string& text, char digit);
std::vector<Change> includes_replaced(const std::string& text,
                                      const std::function<std::optional<std::string>(const std::string&)>& file);
std::vector<Change> lines_left_out(const std::string& text);

}  // namespace verisim::compare
