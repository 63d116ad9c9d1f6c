#include "tracer/base/whole_file.h"

#include <array>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace verisim {

std::optional<std::string> whole_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  std::string bytes;
  std::array<char, 1 << 16> part;
  while (stream) {
    stream.read(part.data(), part.size());
    bytes.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return std::nullopt;  // a folder, for one
  return bytes;
}

std::string required_file(const std::filesystem::path& path) {
  if (std::optional<std::string> bytes = whole_file(path)) return *std::move(bytes);
  throw std::runtime_error("cannot read '" + path.string() + "'");
}

}  // namespace verisim
