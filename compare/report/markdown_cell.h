// Text inside of a Markdown table.
#pragma once

#include <string>

namespace verisim::compare {

// Escapes what Markdown would read as its own; control characters and broken UTF-8 are replaced.
std::string markdown_cell(const std::string& text);

}  // namespace verisim::compare
