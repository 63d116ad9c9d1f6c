#include "tracer/image/formats/byte_reader.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace verisim::image {
namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 16;
constexpr std::int64_t kMaxFile = std::int64_t{1} << 31;

[[noreturn]] void ends_before() { throw std::runtime_error("unexpected end of file"); }

}  // namespace

ByteReader::ByteReader(const std::filesystem::path& path) : file_(std::fopen(path.c_str(), "rb")) {
  if (!file_) throw std::runtime_error("cannot open the file");
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);  // the buffer is ours
  struct stat state {};
  if (::fstat(::fileno(file_.get()), &state) != 0 || !S_ISREG(state.st_mode))
    throw std::runtime_error("cannot read the file");
  if (state.st_size > kMaxFile) throw std::runtime_error("the file is too large");
  size_ = static_cast<std::size_t>(state.st_size);
}

void ByteReader::seek(std::size_t position) {
  if (position > size_) ends_before();
  if (position < start_ || position > end_) {
    if (std::fseek(file_.get(), static_cast<long>(position), SEEK_SET) != 0)
      throw std::runtime_error("cannot read the file");
    start_ = end_ = position;
  }
  position_ = position;
}

void ByteReader::skip(std::size_t n) {
  if (n > left()) ends_before();
  seek(position_ + n);
}

void ByteReader::fill(std::size_t n) {
  if (n > left()) ends_before();
  const std::size_t kept = available(), wanted = std::min(std::max(n, kBuffer), left());
  if (kept > 0) std::memmove(buffer_.data(), buffer_.data() + (position_ - start_), kept);
  if (buffer_.size() < wanted) buffer_.resize(wanted);
  start_ = position_;
  end_ = start_ + kept + std::fread(buffer_.data() + kept, 1, wanted - kept, file_.get());
  if (available() < n) ends_before();  // it was cut off meanwhile
}

void ByteReader::read(void* to, std::size_t n) {
  if (n > left()) ends_before();
  auto* bytes = static_cast<std::uint8_t*>(to);
  const std::size_t ready = std::min(n, available());
  if (ready > 0) std::memcpy(bytes, buffer_.data() + (position_ - start_), ready);
  position_ += ready;
  if (ready == n) return;
  if (n - ready < kBuffer) {
    const auto rest = take(n - ready);
    std::memcpy(bytes + ready, rest.data(), rest.size());
    return;
  }
  if (std::fread(bytes + ready, 1, n - ready, file_.get()) != n - ready) ends_before();
  position_ += n - ready;
  start_ = end_ = position_;
}

}  // namespace verisim::image
