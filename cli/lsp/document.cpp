#include "cli/lsp/document.h"

#include <algorithm>
#include <cctype>

namespace fs = std::filesystem;

namespace verisim::cli::lsp {
namespace {

// Bytes of the character at a byte, and how many units of UTF-16 it has. Bytes that are no UTF-8 count one each.
struct Character {
  std::size_t bytes = 1, units = 1;
};

Character character(std::string_view text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  const std::size_t bytes = byte < 0x80 ? 1 : byte < 0xC2 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : byte < 0xF5 ? 4 : 1;
  if (at + bytes > text.size()) return {};
  for (std::size_t i = 1; i < bytes; ++i)
    if ((static_cast<unsigned char>(text[at + i]) & 0xC0) != 0x80) return {};
  return {bytes, bytes == 4 ? std::size_t{2} : std::size_t{1}};
}

}  // namespace

Text::Text(std::string text) : text_(std::move(text)) { index_lines(); }

void Text::index_lines() {
  starts_.assign(1, 0);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] != '\n' && text_[i] != '\r') continue;
    if (text_[i] == '\r' && i + 1 < text_.size() && text_[i + 1] == '\n') ++i;
    starts_.push_back(i + 1);
  }
}

std::size_t Text::line_end(std::size_t line) const {
  std::size_t end = line + 1 < starts_.size() ? starts_[line + 1] : text_.size();
  while (end > starts_[line] && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
  return end;
}

std::size_t Text::offset(Point point, Columns columns) const {
  if (point.line >= starts_.size()) return text_.size();
  const std::size_t end = line_end(point.line);
  std::size_t at = starts_[point.line];
  if (columns == Columns::utf8) return std::min(at + point.column, end);
  for (std::size_t units = 0; at < end && units < point.column;) {
    const Character c = character(text_, at);
    units += c.units;
    if (units > point.column) break;
    at += c.bytes;
  }
  return at;
}

Point Text::point(std::size_t offset, Columns columns) const {
  offset = std::min(offset, text_.size());
  const auto next = std::upper_bound(starts_.begin(), starts_.end(), offset);
  Point point{static_cast<std::size_t>(next - starts_.begin()) - 1, 0};
  const std::size_t start = starts_[point.line];
  if (columns == Columns::utf8) {
    point.column = offset - start;
    return point;
  }
  for (std::size_t at = start; at < offset;) {
    const Character c = character(text_, at);
    point.column += c.units;
    at += c.bytes;
  }
  return point;
}

std::size_t Text::byte_offset(std::size_t line, std::size_t column) const {
  if (line >= starts_.size()) return text_.size();
  return std::min(starts_[line] + column, line_end(line));
}

void Text::replace(std::size_t begin, std::size_t end, std::string_view with) {
  begin = std::min(begin, text_.size());
  end = std::clamp(end, begin, text_.size());
  text_.replace(begin, end - begin, with);
  index_lines();
}

Point as_point(const Json& position) {
  const auto number = [&](const char* name) {
    const auto value = position.at(name).get<double>();
    return value > 0 ? static_cast<std::size_t>(std::min(value, 4e9)) : std::size_t{0};
  };
  return {number("line"), number("character")};
}

Json as_json(Point point) { return {{"line", point.line}, {"character", point.column}}; }

Json range_json(const Text& text, std::size_t begin, std::size_t end, Columns columns) {
  return {{"start", as_json(text.point(begin, columns))}, {"end", as_json(text.point(end, columns))}};
}

fs::path path_of(const std::string& uri) {
  constexpr std::string_view kScheme = "file://";
  if (!uri.starts_with(kScheme)) return {};
  std::string path;
  std::size_t i = uri.find('/', kScheme.size());  // a host is left out
  for (; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[i + 1])) &&
        std::isxdigit(static_cast<unsigned char>(uri[i + 2]))) {
      path += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      path += uri[i];
    }
  }
  return fs::path(path).lexically_normal();
}

std::string uri_of(const fs::path& path) {
  std::string uri = "file://";
  for (const char c : path.string()) {
    if (std::isalnum(static_cast<unsigned char>(c)) || std::string_view("/-._~").find(c) != std::string_view::npos) {
      uri += c;
    } else {
      constexpr char kDigits[] = "0123456789ABCDEF";
      uri += '%';
      uri += kDigits[static_cast<unsigned char>(c) >> 4];
      uri += kDigits[static_cast<unsigned char>(c) & 15];
    }
  }
  return uri;
}

const parser::NameIndex& Document::index() const {
  if (!index_) index_ = std::make_shared<parser::NameIndex>(text->str());
  return *index_;
}

}  // namespace verisim::cli::lsp
