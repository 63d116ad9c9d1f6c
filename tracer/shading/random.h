// Random numbers of shading: one interface, two sources (spec 06 section 14, 07 section 1).
//
// By default numbers are a hash of (seed, camera sample, way of the ray from there, purpose, count): the picture is the
// same for any number of threads, and whatever is traced before or together. In replay mode they are POV-Ray's own
// streams, read on from sample to sample, which is only meaningful with one thread.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>

namespace verisim::shading {

// u_k of the standard Mersenne twister (seed 5489) scaled to [0, 1), k = 0 .. 32767; read cyclically.
std::span<const double> mersenne_table();

class RandomSource {
 public:
  RandomSource(bool replay, std::uint64_t seed) : replay_(replay), seed_(seed) { begin_sample(0, 0, 0); }

  // Of a sequence of numbers.
  using Key = std::uint64_t;
  // Of a camera ray; (x, y) is its pixel position, n numbers the rays of one position.
  Key sample_key(double x, double y, std::uint32_t n) const {
    std::uint64_t bits[2];
    std::memcpy(bits, &x, 8), std::memcpy(bits + 1, &y, 8);
    return mix(mix(mix(seed_ + 0x9E3779B97F4A7C15u) ^ bits[0]) + (bits[1] ^ (std::uint64_t{n} << 1)));
  }
  // Of what a ray with this key leads to: see RandomBranch.
  static Key branch_key(Key key, std::uint32_t number) { return mix(key ^ (number + 1) * 0xD1342543DE82EF95u); }

  void begin(Key key) {
    if (replay_) return;
    key_ = key;
    for (auto& c : counters_) c = 0;
  }
  // Called at the start of every camera ray.
  void begin_sample(double x, double y, std::uint32_t n) { begin(sample_key(x, y, n)); }

  double shading() { return replay_ ? table(streams_.shading) : next(kShading); }  // area light and rainbow jitter
  double media() { return replay_ ? table(streams_.media) : next(kMedia); }
  double crand() {
    if (!replay_) return next(kCrand);
    streams_.crand = 1812433253u * streams_.crand + 12345u;
    return streams_.crand / 4294967295.0;
  }
  // The n-th of them, n >= 1, of a sequence from its beginning; not in replay mode.
  static double crand(Key key, std::uint64_t n) { return number(key, kCrand, n); }
  // How far POV-Ray's streams have been read.
  struct Streams {
    std::uint32_t shading = 0, media = 0, crand = 0;
  };
  Streams& streams() { return streams_; }
  bool replay() const { return replay_; }
  // Whether any number was drawn since begin().
  bool drawn() const { return drawn_outside_media() || counters_[kMedia] != 0; }
  bool drawn_outside_media() const { return (counters_[kShading] | counters_[kCrand]) != 0; }
  // Of the sequence that is being drawn from.
  Key key() const { return key_; }

 private:
  friend class RandomBranch;
  static std::uint64_t mix(std::uint64_t z) {  // SplitMix64's finaliser (Steele, Lea, Flood 2014)
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
  }
  static constexpr unsigned kShading = 0, kMedia = 1, kCrand = 2;
  static double number(Key key, unsigned purpose, std::uint64_t n) {
    return static_cast<double>(mix(key + (n * 4 + purpose) * 0x9E3779B97F4A7C15u) >> 11) * 0x1p-53;
  }
  double next(unsigned purpose) { return number(key_, purpose, ++counters_[purpose]); }
  static double table(std::uint32_t& index);

  bool replay_;
  std::uint64_t seed_;
  Key key_ = 0;
  std::uint64_t counters_[3] = {};
  Streams streams_;
};

// While it lives, numbers are those of one branch of a ray's tree; POV-Ray's streams go on as ever.
class RandomBranch {
 public:
  RandomBranch(RandomSource& source, std::uint32_t number) : source_(source), key_(source.key_) {
    std::copy_n(source.counters_, 3, counters_);
    source.begin(RandomSource::branch_key(key_, number));
  }
  ~RandomBranch() {
    if (source_.replay_) return;
    source_.key_ = key_;
    std::copy_n(counters_, 3, source_.counters_);
  }
  RandomBranch(const RandomBranch&) = delete;
  RandomBranch& operator=(const RandomBranch&) = delete;

  // The branches of a hit: of the texture-th texture that shows there, the ray behind the surface and the mirror of a
  // layer; the light that a layer gets from other surfaces, and a ray that gathers it; a light; the media of the ray's
  // interiors and what fills the air.
  static std::uint32_t behind(int texture) { return static_cast<std::uint32_t>(texture) << 8; }
  static std::uint32_t mirror(int texture, int layer) {
    return behind(texture) + 1 + static_cast<std::uint32_t>(layer);
  }
  static std::uint32_t indirect(int texture, int layer) { return mirror(texture, layer) + (1u << 29); }
  static std::uint32_t gather(std::size_t ray) { return indirect(0, 0) + (1u << 28) + static_cast<std::uint32_t>(ray); }
  static std::uint32_t light(std::size_t index) { return (1u << 30) + static_cast<std::uint32_t>(index); }
  static constexpr std::uint32_t kContainer = 1u << 31, kAir = kContainer + 1;

 private:
  RandomSource& source_;
  RandomSource::Key key_;
  std::uint64_t counters_[3];
};

}  // namespace verisim::shading
