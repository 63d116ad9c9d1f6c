#include "parser/source/source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "tracer/base/descriptor.h"

namespace verisim::parser {
namespace {

constexpr const char* kTooLong = "it has more bytes than --max-file-bytes allows";

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw std::runtime_error("Cannot read '" + path.string() + "': " + reason + ".");
}

}  // namespace

Source::Source(std::string name, std::string_view text) : Source(std::move(name)) {
  size_ = text.size();
  bytes_ = std::make_unique_for_overwrite<char[]>(size_ + 1);
  std::copy(text.begin(), text.end(), bytes_.get());
  bytes_[size_] = '\0';
}

std::shared_ptr<Source> Source::of(std::string name, std::string_view text, std::size_t max_bytes) {
  if (text.size() > max_bytes) fail(name, kTooLong);
  return std::make_shared<Source>(std::move(name), text);
}

std::shared_ptr<Source> Source::read(const std::filesystem::path& path, std::string name, std::size_t max_bytes) {
  // O_NONBLOCK: a FIFO named as a scene must not hang the program.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) fail(path, std::strerror(errno));
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) fail(path, std::strerror(errno));
  if (S_ISDIR(info.st_mode)) fail(path, "it is a directory");
  if (!S_ISREG(info.st_mode)) fail(path, "it is not a regular file");
  const auto size = static_cast<std::size_t>(info.st_size);
  if (size > max_bytes) fail(path, kTooLong);
  std::shared_ptr<Source> source(new Source(std::move(name)));
  source->bytes_ = std::make_unique_for_overwrite<char[]>(size + 1);
  while (source->size_ < size) {
    const ssize_t got = ::read(file.get(), source->bytes_.get() + source->size_, size - source->size_);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path, std::strerror(errno));
    if (got == 0) break;
    source->size_ += static_cast<std::size_t>(got);
  }
  source->bytes_[source->size_] = '\0';
  return source;
}

void Source::add_line(std::size_t start) const {
  if (lines_++ % kStep == 0) starts_.push_back(start);
}

// The byte after the line end that begins at byte i; 0: none begins there.
std::size_t Source::after_line_end(std::size_t i) const {
  const char c = bytes_[i];
  if (c != '\n' && c != '\r') return 0;
  const char other = c == '\n' ? '\r' : '\n';
  return i + 1 < size_ && bytes_[i + 1] == other ? i + 2 : i + 1;
}

void Source::index_lines(std::size_t up_to) const {
  const char* p = bytes_.get();
  std::size_t i = indexed_;
  // Line feeds alone, as nearly always: the library finds them fast.
  const std::size_t stop = std::min(size_, up_to + 1);
  if (i < stop && !std::memchr(p + i, '\r', std::min(size_, stop + 1) - i)) {
    while (const void* feed = std::memchr(p + i, '\n', stop - i)) {
      i = static_cast<std::size_t>(static_cast<const char*>(feed) - p) + 1;
      add_line(i);
    }
    i = stop;
  }
  while (i < size_ && i <= up_to) {
    const std::size_t next = after_line_end(i);
    if (next) {
      add_line(next);
      if (p[next - 1] != '\n') lines_end_in_feeds_ = false;
    }
    i = next ? next : i + 1;
  }
  indexed_ = std::max(indexed_, i);
}

Position Source::position(std::size_t offset) const {
  offset = std::min(offset, size_);
  index_lines(offset);
  const auto block = std::upper_bound(starts_.begin(), starts_.end(), offset) - 1;
  std::size_t index = static_cast<std::size_t>(block - starts_.begin()) * kStep, start = *block;
  const auto next_line = [&]() -> std::size_t {  // 0: it begins after the offset
    if (lines_end_in_feeds_) {
      const char* const p = bytes_.get();
      const void* const feed = std::memchr(p + start, '\n', offset - start);
      return feed ? static_cast<std::size_t>(static_cast<const char*>(feed) - p) + 1 : 0;
    }
    for (std::size_t i = start; i < offset; ++i)
      if (const std::size_t next = after_line_end(i)) return next <= offset ? next : 0;
    return 0;
  };
  while (const std::size_t next = next_line()) ++index, start = next;
  return {static_cast<int>(index) + 1, static_cast<int>(offset - start) + 1};
}

std::string_view Source::line(int number) const {
  if (number < 1 || static_cast<std::size_t>(number) > lines_) return {};
  const auto index = static_cast<std::size_t>(number) - 1;
  std::size_t i = starts_[index / kStep];
  for (std::size_t left = index % kStep; left > 0;) {
    const std::size_t next = after_line_end(i);
    i = next ? next : i + 1;
    left -= next != 0;
  }
  const std::string_view rest = text().substr(i);
  return rest.substr(0, rest.find_first_of("\r\n"));
}

}  // namespace verisim::parser
