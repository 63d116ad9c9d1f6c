// What the fuzzers call, also called by an ordinary test with the kept corpus. Each takes any bytes; a broken promise
// ends the program.
#pragma once

#include <string_view>

namespace verisim::fuzz {

// Tokens of any bytes are in order, inside the text, and their links, strings and vectors lead to where they should.
void lexer(std::string_view bytes);
// A scene of any bytes ends in a scene or in diagnostics, within limits; a scene can be dumped and its limits name
// their options.
void scene(std::string_view bytes);
// A scene that can be read is drawn, small: with one thread and with two, to the same bits.
void render(std::string_view bytes);
// A function of any bytes compiles or is refused; one point at a time, batches and inlining into another function give
// the same bits.
void function(std::string_view bytes);

}  // namespace verisim::fuzz
