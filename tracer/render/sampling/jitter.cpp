#include "tracer/render/sampling/jitter.h"

#include <utility>

namespace verisim::render {
namespace {

constexpr std::array<std::uint16_t, 4096> make_permutation() {
  std::array<std::uint16_t, 4096> p{};
  for (std::uint32_t i = 0; i < 4096; ++i) p[i] = static_cast<std::uint16_t>(i);
  std::uint32_t g = 0;
  for (int i = 4095; i >= 0; --i) {
    g = 1812433253u * g + 12345u;
    std::swap(p[i], p[((g >> 16) & 32767) % 4096]);
  }
  return p;
}

// CRC-16 (reflected polynomial 0xA001) of one byte, its low 15 bits mapped to [-0.5, 0.5), rounded to six decimals and
// held in single precision: measured through lens rays, whose hits on a far wall show the last bits of each of the 256
// values.
constexpr std::array<double, 256> make_offsets() {
  std::array<double, 256> t{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t crc = i;
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xA001u : crc >> 1;
    const double millionths = ((crc & 32767) / 32768.0 - 0.5) * 1e6;
    t[i] = static_cast<float>(static_cast<int>(millionths + (millionths < 0 ? -0.5 : 0.5)) / 1e6);
  }
  return t;
}

// Tables of constants, so that nobody asks whether they are there yet.
constexpr std::array<std::uint16_t, 4096> kPermutation = make_permutation();
constexpr std::array<double, 256> kOffsets = make_offsets();

std::uint32_t hash_part(double v) { return static_cast<std::uint32_t>(static_cast<std::int64_t>(v)); }

}  // namespace

const std::array<std::uint16_t, 4096>& permutation() { return kPermutation; }

Vec2 jitter2(double x, double y) {
  const auto hash = [](double a, double b) {
    return kPermutation[(kPermutation[hash_part(a) & 4095] ^ hash_part(b)) & 4095] & 255;
  };
  return {kOffsets[hash(1021 * x, 1019 * y)], kOffsets[hash(1019 * x, 1021 * y)]};
}

double radical_inverse(int base, std::uint32_t n) {
  double result = 0, digit = 1.0 / base;
  for (; n > 0; n /= base, digit /= base) result += digit * (n % base);
  return result;
}

}  // namespace verisim::render
