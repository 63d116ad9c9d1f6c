// A file as an editor holds it: text that changes, places as the protocol counts them, and what the tokens say of it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/lsp/protocol.h"
#include "parser/editing/index.h"

namespace verisim::cli::lsp {

// Columns count units of UTF-16, or bytes where client and server have agreed on UTF-8.
enum class Columns { utf16, utf8 };

// 0-based, as the protocol has them.
struct Point {
  std::size_t line = 0, column = 0;
};

// Text with its lines.
class Text {
 public:
  explicit Text(std::string text = {});
  const std::string& str() const { return text_; }
  std::size_t lines() const { return starts_.size(); }

  // Places behind the end of a line or of the text are moved to it.
  std::size_t offset(Point point, Columns columns) const;
  Point point(std::size_t offset, Columns columns) const;
  // Of a line counted from 0 and a column of bytes counted from 0.
  std::size_t byte_offset(std::size_t line, std::size_t column) const;
  void replace(std::size_t begin, std::size_t end, std::string_view with);

 private:
  void index_lines();
  std::size_t line_end(std::size_t line) const;  // before the line end

  std::string text_;
  std::vector<std::size_t> starts_;
};

Point as_point(const Json& position);
Json as_json(Point point);
Json range_json(const Text& text, std::size_t begin, std::size_t end, Columns columns);

// file:// URIs; a path that is empty: another kind of URI.
std::filesystem::path path_of(const std::string& uri);
std::string uri_of(const std::filesystem::path& path);

struct Document {
  std::string uri;
  std::filesystem::path path;  // normal and absolute; empty: not a file (yet)
  int version = 0;
  std::shared_ptr<const Text> text = std::make_shared<Text>();

  // Made when it is asked for after a change.
  const parser::NameIndex& index() const;
  void changed() { index_.reset(); }

 private:
  mutable std::shared_ptr<const parser::NameIndex> index_;
};

}  // namespace verisim::cli::lsp
