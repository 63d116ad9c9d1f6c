// The bytes of one file and the way from a byte offset to line and column.
//
// Files are read, not mapped: a scene may rewrite a file it has included (spec 01 section 17), and a mapping would
// change or vanish under the tokens.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace verisim::parser {

struct Position {
  int line = 1, column = 1;  // 1-based; columns count bytes
};

class Source {
 public:
  // Takes a copy of `text`; the bytes are followed by a NUL, so scanners need no bounds check at every step.
  Source(std::string name, std::string_view text);
  // Reads a file. Throws std::runtime_error with a reason for people (missing, a directory, larger than max_bytes, not
  // readable).
  static std::shared_ptr<Source> of(std::string name, std::string_view text,
                                    std::size_t max_bytes);  // of a file in memory
  static std::shared_ptr<Source> read(const std::filesystem::path& path, std::string name, std::size_t max_bytes);

  const std::string& name() const { return *name_; }
  const std::shared_ptr<const std::string>& shared_name() const { return name_; }
  std::string_view text() const { return {bytes_.get(), size_}; }

  // LF, CR, CRLF and LFCR count as one line end each. The index of lines is extended only as far as it is asked for.
  Position position(std::size_t offset) const;
  // The text of a line (1-based) without its end.
  std::string_view line(int number) const;

 private:
  explicit Source(std::string name) : name_(std::make_shared<const std::string>(std::move(name))) {}
  void index_lines(std::size_t up_to) const;
  void add_line(std::size_t start) const;
  std::size_t after_line_end(std::size_t i) const;

  std::shared_ptr<const std::string> name_;
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
  static constexpr std::size_t kStep = 8;
  mutable std::vector<std::uint64_t> starts_{0};  // of lines 1, 1 + kStep, 1 + 2 kStep ...
  mutable std::size_t lines_ = 1;                 // whose beginnings have been met
  mutable std::size_t indexed_ = 0;               // bytes looked at
  mutable bool lines_end_in_feeds_ = true;  // all that have ended: the last byte of each end, and nothing else, is one
};

}  // namespace verisim::parser
