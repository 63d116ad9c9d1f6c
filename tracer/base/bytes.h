// Plain values as bytes in a string, and back: what files of ours hold. Little-endian, on every machine.
#pragma once

#include <array>
#include <bit>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace verisim {

static_assert(std::endian::native == std::endian::little, "files of other machines would be read wrongly");

template <class T>
void put_bytes(std::string& out, const T& value) {
  static_assert(std::is_arithmetic_v<T>);
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}
// One after the other.
template <class T, std::size_t N>
void put_bytes(std::string& out, const std::array<T, N>& values) {
  static_assert(std::is_arithmetic_v<T>);
  out.append(reinterpret_cast<const char*>(values.data()), sizeof values);
}

// Takes values from the front of bytes that somebody else keeps. Throws std::runtime_error at their end.
class ByteSource {
 public:
  explicit ByteSource(std::string_view bytes) : bytes_(bytes) {}
  std::size_t left() const { return bytes_.size(); }
  std::string_view take_bytes(std::size_t count) {
    if (count > bytes_.size()) throw std::runtime_error("the data end too early");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  template <class T>
  T take() {
    static_assert(std::is_arithmetic_v<T>);
    T value;
    std::memcpy(&value, take_bytes(sizeof value).data(), sizeof value);
    return value;
  }

 private:
  std::string_view bytes_;
};

}  // namespace verisim
