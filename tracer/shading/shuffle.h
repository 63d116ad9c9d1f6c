// Shuffles of a few numbers, and random numbers for each, from a key.
#pragma once

#include <cstdint>
#include <vector>

namespace verisim::shading {

// Independent of each other for different n or key.
inline std::uint64_t scrambled(std::uint32_t n, std::uint64_t key) {
  std::uint64_t z = key + n * 0x9E3779B97F4A7C15u;
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return z ^ z >> 31;
}

class Shuffle {
 public:
  // Of the numbers below n.
  void begin(std::uint32_t n, std::uint64_t key) {
    keys_.resize(n), places_.assign(n, kUnknown);
    for (std::uint32_t i = 0; i < n; ++i) keys_[i] = scrambled(i, key);
  }
  // Where i stands.
  std::uint32_t place(std::uint32_t i) {
    if (places_[i] == kUnknown) {
      std::uint32_t before = 0;
      for (std::uint32_t j = 0; j < keys_.size(); ++j)
        before += static_cast<std::uint32_t>((keys_[j] < keys_[i]) | ((keys_[j] == keys_[i]) & (j < i)));
      places_[i] = before;
    }
    return places_[i];
  }

 private:
  static constexpr auto kUnknown = static_cast<std::uint32_t>(-1);
  std::vector<std::uint64_t> keys_;
  std::vector<std::uint32_t> places_;
};

}  // namespace verisim::shading
