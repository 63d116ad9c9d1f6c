#include "parser/source/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
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
// "scene.pov:3:7"
std::string where(const Excerpt& place) {
  std::string out = printable(place.file);
  if (place.line > 0) out += fmt::format(":{}", place.line);
  if (place.line > 0 && place.column > 0) out += fmt::format(":{}", place.column);
  return out;
}

// The line with what is meant underlined: `mark`, and '~' up to its end.
std::string picture(const Excerpt& place, char mark, std::string_view tint, std::string_view reset) {
  const std::string& line = place.source_line;
  if (line.empty()) return {};
  std::string out = fmt::format("{:>6} | {}\n", place.line, printable(line));
  const auto caret = static_cast<std::size_t>(std::max(place.caret > 0 ? place.caret : place.column, 0));
  if (caret == 0 || caret > line.size() + 1) return out;
  // Columns count bytes; continuation bytes of UTF-8 take no place on the screen.
  const auto columns = [&](std::size_t from, std::size_t to) {
    std::size_t n = 0;
    for (std::size_t i = from; i < std::min(to, line.size()); ++i)
      n += (static_cast<unsigned char>(line[i]) & 0xc0) != 0x80;
    return n;
  };
  const std::size_t under = columns(caret - 1, caret - 1 + static_cast<std::size_t>(std::max(place.length, 0)));
  out += fmt::format("       | {}{}{}{}{}\n", std::string(columns(0, caret - 1), ' '), tint, mark,
                     std::string(under > 1 ? under - 1 : 0, '~'), reset);
  return out;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '\t' ? ' ' : static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return out;
}

std::string format(const Diagnostic& d, bool color) {
  const Style s = style(d.severity);
  const std::string_view bold = color ? "\033[1m" : "", reset = color ? "\033[0m" : "", tint = color ? s.color : "";
  std::string out;
  if (!d.file.empty()) out += fmt::format("{}{}:{} ", bold, where(d), reset);
  out += fmt::format("{}{}:{} {} [{}]\n", tint, s.label, reset, printable(d.message), name(d.code));
  out += picture(d, '^', tint, reset);
  if (!d.advice.empty()) out += fmt::format("         {}\n", printable(d.advice));
  for (const Related& r : d.related) {
    out += fmt::format("         {}: {}\n", where(r.place), printable(r.message));
    if (r.place.file != d.file || r.place.line != d.line) out += picture(r.place, '-', tint, reset);
  }
  for (const std::string& step : d.trail) out += fmt::format("         {}\n", printable(step));
  return out;
}

}  // namespace verisim::parser
