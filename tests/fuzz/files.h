// Entry points of the fuzzers for files that are not scenes: what is wrong with them must end in std::runtime_error.
// Each is a function of the bytes of such a file.
#pragma once

#include <string_view>

namespace verisim::fuzz {

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
