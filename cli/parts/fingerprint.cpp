#include "cli/parts/fingerprint.h"

#include <bit>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

namespace verisim::cli {
namespace {

std::uint64_t mixed(std::uint64_t h) {  // the finaliser of SplitMix64
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebull;
  return h ^ (h >> 31);
}

}  // namespace

std::uint64_t checksum(std::string_view data, std::uint64_t seed) {
  const char* bytes = data.data();
  std::size_t count = data.size();
  std::uint64_t hash = mixed(seed + count);
  for (; count >= 8; bytes += 8, count -= 8) {
    std::uint64_t word;
    std::memcpy(&word, bytes, 8);
    hash = mixed(hash ^ word) + 0x9e3779b97f4a7c15ull;
  }
  std::uint64_t rest = 0;
  std::memcpy(&rest, bytes, count);
  return mixed(hash ^ rest);
}

void Fingerprint::add(std::string_view bytes) { hash_ = checksum(bytes, hash_); }
void Fingerprint::add(double value) { hash_ = mixed(hash_ ^ std::bit_cast<std::uint64_t>(value)); }
void Fingerprint::add_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::error_code ignored;
  std::string buffer(1 << 16, '\0');
  add(path.filename().string());
  while (stream) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    add(std::string_view(buffer.data(), static_cast<std::size_t>(stream.gcount())));
  }
  if (stream.bad() || (!stream.is_open() && std::filesystem::exists(path, ignored)))
    throw std::runtime_error("cannot read '" + path.string() + "' again");
}

}  // namespace verisim::cli
