// Low-discrepancy sample values: Owen-scrambled Sobol points, padded pair by pair (Burley, "Practical Hash-based Owen
// Scrambling", JCGT 2020).
#pragma once

#include <cstdint>
#include <cstring>

#include "tracer/base/bits.h"
#include "tracer/math/vec.h"

namespace verisim::path {

namespace detail {
inline std::uint32_t mixed(std::uint64_t z) {  // SplitMix64's finaliser (Steele, Lea, Flood 2014)
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return static_cast<std::uint32_t>((z ^ z >> 31) >> 16);
}
// A hash in which every bit depends on lower ones only (Laine and Karras 2011, with the constants of Vegdahl 2021).
inline std::uint32_t laine_karras(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}
inline std::uint32_t owen(std::uint32_t x, std::uint32_t seed) {
  return reverse_bits(laine_karras(reverse_bits(x), seed));
}
// The second dimension of Sobol's sequence: Pascal's triangle modulo 2.
inline std::uint32_t sobol2(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t v = 0x80000000u; index; index >>= 1, v ^= v >> 1)
    if (index & 1u) result ^= v;
  return result;
}
}  // namespace detail

// One path's numbers. They depend on seed, pixel position and the number of the sample alone.
class Sequence {
 public:
  Sequence(std::uint64_t seed, double x, double y) {
    std::uint64_t bits[2];
    std::memcpy(bits, &x, 8), std::memcpy(bits + 1, &y, 8);
    key_ = detail::mixed(seed * 0x9E3779B97F4A7C15u + bits[0]) ^ (std::uint64_t{detail::mixed(bits[1] + seed)} << 32);
  }
  void begin(std::uint32_t sample) { sample_ = sample, dimension_ = 0; }
  // Uniform in the unit square; neighbouring samples spread evenly over it.
  Vec2 next2() {
    const std::uint32_t seed = detail::mixed(key_ + 0x9E3779B97F4A7C15u * ++dimension_),
                        index = detail::owen(sample_, seed);
    return {to_unit(detail::owen(reverse_bits(index), detail::mixed(seed + 1u))),
            to_unit(detail::owen(detail::sobol2(index), detail::mixed(seed + 2u)))};
  }
  double next() {
    const std::uint32_t seed = detail::mixed(key_ + 0x9E3779B97F4A7C15u * ++dimension_),
                        index = detail::owen(sample_, seed);
    return to_unit(detail::owen(reverse_bits(index), detail::mixed(seed + 1u)));
  }

 private:
  static double to_unit(std::uint32_t x) { return (x + 0.5) * 0x1p-32; }
  std::uint64_t key_;
  std::uint32_t sample_ = 0;
  std::uint64_t dimension_ = 0;
};

}  // namespace verisim::path
