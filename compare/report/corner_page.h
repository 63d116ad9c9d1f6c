// A page in which the four corners of a render are picked in a photograph (docs/photograph.md).
#pragma once

#include <filesystem>
#include <string>

namespace verisim::compare {

// One HTML file that asks for nothing else; it shows the call of `verisim diff` and the lines of a manifest that hold
// the corners. Throws std::runtime_error when a picture cannot be read.
std::string corner_page(const std::filesystem::path& photograph, const std::filesystem::path& render);

}  // namespace verisim::compare
