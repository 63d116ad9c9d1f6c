// The parser's front door: a scene file in, a scene description or diagnostics out.
#pragma once

#include <filesystem>
#include <string>

#include "parser/source/options.h"

namespace verisim::parser {

ParseResult parse_file(const std::filesystem::path& path, const ParseOptions& options);
// The same from memory; `name` appears in messages.
ParseResult parse_text(const std::string& text, const std::string& name, const ParseOptions& options);

}  // namespace verisim::parser
