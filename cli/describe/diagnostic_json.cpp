#include "cli/describe/diagnostic_json.h"

namespace verisim::cli {
namespace {

const char* name_of(parser::Severity severity) {
  switch (severity) {
    case parser::Severity::warning:
      return "warning";
    case parser::Severity::possible_error:
      return "possible error";
    case parser::Severity::error:
      return "error";
    case parser::Severity::unsupported:
      return "unsupported";
  }
  return "";
}

}  // namespace

nlohmann::json as_json(const parser::Diagnostic& d) {
  return {{"file", d.file},       {"line", d.line},     {"column", d.column},      {"severity", name_of(d.severity)},
          {"message", d.message}, {"advice", d.advice}, {"source", d.source_line}, {"trail", d.trail}};
}

}  // namespace verisim::cli
