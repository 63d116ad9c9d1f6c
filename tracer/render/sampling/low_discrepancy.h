// Owen-scrambled Sobol points of two dimensions (Sobol' 1967; Burley, "Practical Hash-based Owen Scrambling", JCGT
// 9(4), 2020): the first 2^k points of a pixel are stratified over all 2^k elementary intervals, for every k, so a
// pixel can go on sampling without losing what it has.
#pragma once

#include <cstdint>

#include "tracer/base/bits.h"
#include "tracer/math/vec.h"

namespace verisim::render {

// Permutes nested intervals of a point whose bits are reversed (Laine and Karras 2011, with Burley's constants).
inline std::uint32_t permute_nested(std::uint32_t reversed, std::uint32_t seed) {
  reversed += seed;
  reversed ^= reversed * 0x6C50B47Cu;
  reversed ^= reversed * 0xB82F1E52u;
  reversed ^= reversed * 0xC7AFE638u;
  reversed ^= reversed * 0x8D22F6E6u;
  return reversed;
}

class LowDiscrepancy {
 public:
  // Another scrambling for every pixel and seed.
  LowDiscrepancy(std::int32_t x, std::int32_t y, std::uint64_t seed) {
    std::uint64_t z = seed + 0x9E3779B97F4A7C15u * (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32 |
                                                    static_cast<std::uint32_t>(y));
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;  // SplitMix64's finaliser
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    z ^= z >> 31;
    seed_x_ = static_cast<std::uint32_t>(z), seed_y_ = static_cast<std::uint32_t>(z >> 32);
  }
  // Point n in [0, 1)^2.
  Vec2 operator()(std::uint32_t n) const {
    std::uint32_t second = 0, direction = 0x80000000u;
    for (std::uint32_t bits = n; bits; bits >>= 1, direction ^= direction >> 1)
      if (bits & 1) second ^= direction;
    // The first dimension is the index with its bits reversed, so its reversal is the index.
    return {reverse_bits(permute_nested(n, seed_x_)) * 0x1p-32,
            reverse_bits(permute_nested(reverse_bits(second), seed_y_)) * 0x1p-32};
  }

 private:
  std::uint32_t seed_x_, seed_y_;
};

}  // namespace verisim::render
