// Random numbers of shading: one interface, two sources (spec 06 section 14, 07 section 1).
//
// By default numbers are a hash of (seed, camera sample, purpose, count): the picture is the same for any number of threads. In replay mode they are
// POV-Ray's own streams, read on from sample to sample, which is only meaningful with one thread.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>

namespace verisim::shading {

// u_k of the standard Mersenne twister (seed 5489) scaled to [0, 1), k = 0 .. 32767; read cyclically.
std::span<const double> mersenne_table();

class RandomSource {
 public:
  RandomSource(bool replay, std::uint64_t seed) : replay_(replay), seed_(seed) { begin_sample(0, 0, 0); }

  // Called at the start of every camera ray; (x, y) is its pixel position, n numbers the rays of one position.
  void begin_sample(double x, double y, std::uint32_t n) {
    if (replay_) return;
    std::uint64_t bits[2];
    std::memcpy(bits, &x, 8), std::memcpy(bits + 1, &y, 8);
    key_ = mix(mix(mix(seed_ + 0x9E3779B97F4A7C15u) ^ bits[0]) + (bits[1] ^ (std::uint64_t{n} << 1)));
    for (auto& c : counters_) c = 0;
  }

  double shading() { return replay_ ? table(shading_index_) : next(0); }  // area light and rainbow jitter
  double media() { return replay_ ? table(media_index_) : next(1); }
  double crand() {
    if (!replay_) return next(2);
    crand_state_ = 1812433253u * crand_state_ + 12345u;
    return crand_state_ / 4294967295.0;
  }
  bool replay() const { return replay_; }

 private:
  static std::uint64_t mix(std::uint64_t z) {  // SplitMix64's finaliser (Steele, Lea, Flood 2014)
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
  }
  double next(unsigned purpose) {
    return static_cast<double>(mix(key_ + (++counters_[purpose] * 4 + purpose) * 0x9E3779B97F4A7C15u) >> 11) * 0x1p-53;
  }
  static double table(std::uint32_t& index);

  bool replay_;
  std::uint64_t seed_, key_ = 0;
  std::uint64_t counters_[3] = {};
  std::uint32_t shading_index_ = 0, media_index_ = 0, crand_state_ = 0;
};

}  // namespace verisim::shading
