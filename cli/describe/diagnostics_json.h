// Diagnostics for other programs: the JSON of `verisim check --json`, and SARIF 2.1.0, which code hosts show beside the
// lines.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "parser/source/diagnostic.h"

namespace verisim::cli {

const char* name_of(parser::Severity severity);
nlohmann::json as_json(const parser::Diagnostic& diagnostic);
// A whole SARIF log. Written whole or not at all; throws std::runtime_error.
void write_sarif(const std::vector<parser::Diagnostic>& diagnostics, const std::string& file);

}  // namespace verisim::cli
