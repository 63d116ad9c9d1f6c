// The parser's front door: a scene file in, a scene description or diagnostics out.
#pragma once

#include <filesystem>
#include <string>

#include "parser/source/options.h"

namespace verisim::parser {

// What is wrong with a scene is in the result, never thrown; only exceptions of the callbacks in `options` pass through
// (except those derived from std::exception, which end parsing as an error). May be called from any number of threads
// at a time. `options` need not live longer than the call.
ParseResult parse_file(const std::filesystem::path& path, const ParseOptions& options);
// The same from memory; `name` appears in messages. Files are looked for in the current folder, the library paths and
// ParseOptions::scene_folder.
ParseResult parse_text(const std::string& text, const std::string& name, const ParseOptions& options);

}  // namespace verisim::parser
