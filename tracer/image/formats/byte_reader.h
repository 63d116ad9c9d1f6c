// Bounds-checked reading of binary files, a buffer at a time: the file is never in memory as a whole.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace verisim::image {

class ByteReader {
 public:
  // Throws std::runtime_error when it cannot be read or is larger than any picture should be.
  explicit ByteReader(const std::filesystem::path& path);

  std::size_t size() const { return size_; }
  std::size_t position() const { return position_; }
  std::size_t left() const { return size_ - position_; }

  // All throw std::runtime_error where the file ends before.
  void seek(std::size_t position);
  void skip(std::size_t n);
  // Valid until the next call.
  std::span<const std::uint8_t> take(std::size_t n) {
    if (n > available()) fill(n);
    position_ += n;
    return {buffer_.data() + (position_ - n - start_), n};
  }
  void read(void* to, std::size_t n);
  std::uint8_t u8() {
    if (available() == 0) fill(1);
    return buffer_[position_++ - start_];
  }
  std::uint16_t le16() {
    const auto b = take(2);
    return static_cast<std::uint16_t>(b[0] | b[1] << 8);
  }
  std::uint32_t le32() {
    const auto b = take(4);
    return b[0] | static_cast<std::uint32_t>(b[1]) << 8 | static_cast<std::uint32_t>(b[2]) << 16 |
           static_cast<std::uint32_t>(b[3]) << 24;
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::size_t available() const { return end_ - position_; }
  void fill(std::size_t n);  // makes n bytes available

  std::unique_ptr<std::FILE, Close> file_;
  std::size_t size_ = 0, position_ = 0;
  // The bytes [start_, end_) of the file; position_ is among them or at their end.
  std::vector<std::uint8_t> buffer_;
  std::size_t start_ = 0, end_ = 0;
};

}  // namespace verisim::image
