// Diagnostics for other programs: the JSON of `verisim check --json`, and SARIF 2.1.0, which code hosts show beside the
// lines.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "parser/source/diagnostic.h"

namespace verisim::cli {

const char* name_of(parser::Severity severity);
nlohmann::json as_json(const parser::Diagnostic& diagnostic);
// A finding that has a rule of its own beside the codes.
struct OtherFinding {
  std::string_view rule, title, text;  // of the rule
  parser::Excerpt place;
  std::string message;
};
// A whole SARIF log. Written whole or not at all; throws std::runtime_error.
void write_sarif(const std::vector<parser::Diagnostic>& diagnostics, const std::vector<OtherFinding>& others,
                 const std::string& file);

}  // namespace verisim::cli
