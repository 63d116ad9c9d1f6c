// Checksums of data, and one number for everything that a picture depends on. They find accidents, not forgeries.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace verisim::cli {

std::uint64_t checksum(std::string_view bytes, std::uint64_t seed);

// Collects what a picture depends on into one number.
class Fingerprint {
 public:
  void add(std::string_view bytes);
  void add(double value);
  void add_file(const std::filesystem::path&
                    path);  // its content; one that is not there counts as empty. Throws std::runtime_error.
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0x9e3779b97f4a7c15ull;
};

}  // namespace verisim::cli
