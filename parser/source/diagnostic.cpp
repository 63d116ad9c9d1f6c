#include "parser/source/diagnostic.h"

#include <fmt/format.h>

#include <string_view>

namespace verisim::parser {
namespace {

struct Style {
  std::string_view label, color;
};

Style style(Severity severity) {
  switch (severity) {
    case Severity::warning:
      return {"warning", "\033[1;35m"};
    case Severity::possible_error:
      return {"possible error", "\033[1;33m"};
    case Severity::error:
      return {"error", "\033[1;31m"};
    case Severity::unsupported:
      return {"not supported", "\033[1;31m"};
  }
  return {"error", ""};
}

// Control characters of a hostile file must not reach the terminal.
std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '\t' ? ' ' : static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return out;
}

}  // namespace

std::string format(const Diagnostic& d, bool color) {
  const Style s = style(d.severity);
  const std::string_view bold = color ? "\033[1m" : "", reset = color ? "\033[0m" : "", tint = color ? s.color : "";
  std::string out;
  if (!d.file.empty()) {
    out += fmt::format("{}{}", bold, printable(d.file));
    if (d.line > 0) out += fmt::format(":{}", d.line);
    if (d.line > 0 && d.column > 0) out += fmt::format(":{}", d.column);
    out += fmt::format(":{} ", reset);
  }
  out += fmt::format("{}{}:{} {}\n", tint, s.label, reset, printable(d.message));
  if (!d.source_line.empty()) {
    const int caret = d.caret > 0 ? d.caret : d.column;
    out += fmt::format("{:>6} | {}\n", d.line, printable(d.source_line));
    if (caret > 0 && static_cast<std::size_t>(caret) <= d.source_line.size() + 1) {
      // Columns count bytes; continuation bytes of UTF-8 take no place on the screen.
      std::size_t blanks = 0;
      for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(caret); ++i)
        blanks += (static_cast<unsigned char>(d.source_line[i]) & 0xc0) != 0x80;
      out += fmt::format("       | {}{}^{}\n", std::string(blanks, ' '), tint, reset);
    }
  }
  if (!d.advice.empty()) out += fmt::format("         {}\n", printable(d.advice));
  for (const std::string& step : d.trail) out += fmt::format("         {}\n", printable(step));
  return out;
}

}  // namespace verisim::parser
