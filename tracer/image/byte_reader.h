// Bounds-checked reading of binary formats.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>

namespace verisim::image {

class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }
  void seek(std::size_t position) {
    if (position > bytes_.size()) throw std::runtime_error("unexpected end of file");
    position_ = position;
  }
  void skip(std::size_t n) { take(n); }
  std::span<const std::uint8_t> take(std::size_t n) {
    if (n > left()) throw std::runtime_error("unexpected end of file");
    position_ += n;
    return bytes_.subspan(position_ - n, n);
  }
  std::uint8_t u8() { return take(1)[0]; }
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
  std::span<const std::uint8_t> bytes_;
  std::size_t position_ = 0;
};

}  // namespace verisim::image
