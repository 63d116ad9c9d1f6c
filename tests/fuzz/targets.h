// What the fuzzers call, also called by an ordinary test with the kept corpus. Each takes any bytes; a broken promise
// ends the program. Each has a source of its own in targets/, so that its fuzzer holds the code that it tries and no
// more: the fewer places there are to count, the more inputs are tried in a second.
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

// Files that are not scenes: what is wrong with them must end in std::runtime_error.
void image(std::string_view bytes);      // the first byte chooses the file type that the scene names
void picture(std::string_view bytes);    // what `verisim diff` reads
void density(std::string_view bytes);    // df3
void font(std::string_view bytes);       // TrueType
void photons(std::string_view bytes);    // photons { load_file }
void radiosity(std::string_view bytes);  // +RFI
void ini(std::string_view bytes);
void manifest(std::string_view bytes);  // verisim.toml
void state(std::string_view bytes);     // +C
void part(std::string_view bytes);      // --part, merge
// What a client sends to the language server, a message a line after `initialize`; behind a zero byte: all of the wire.
void lsp(std::string_view bytes);

struct FileTarget {
  std::string_view name;  // of the target and of its corpus
  void (*run)(std::string_view bytes);
};
inline constexpr FileTarget kFileTargets[] = {
    {"image", image},     {"picture", picture},     {"density", density}, {"font", font},
    {"photons", photons}, {"radiosity", radiosity}, {"ini", ini},         {"manifest", manifest},
    {"state", state},     {"part", part},           {"lsp", lsp}};

}  // namespace verisim::fuzz
