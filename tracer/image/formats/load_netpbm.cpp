// PGM and PPM, text and binary, any maxval up to 65535.
#include <cstring>
#include <stdexcept>
#include <string>

#include "tracer/image/formats/byte_reader.h"
#include "tracer/image/formats/raw_image.h"

namespace verisim::image {
namespace {

bool is_space(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// The next number; comments run from # to the end of the line.
int number(ByteReader& in) {
  int c = in.u8();
  while (is_space(c) || c == '#') {
    if (c == '#')
      while (c != '\n') c = in.u8();
    c = in.u8();
  }
  if (c < '0' || c > '9') throw std::runtime_error("a number was expected");
  std::int64_t value = 0;
  while (c >= '0' && c <= '9') {
    value = value * 10 + (c - '0');
    if (value > 0x7fffffff) throw std::runtime_error("a number is too large");
    if (in.left() == 0) break;
    c = in.u8();  // also eats the one separator after maxval
  }
  return static_cast<int>(value);
}

void words_from_big_endian(std::uint16_t* words, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    std::uint8_t bytes[2];
    std::memcpy(bytes, words + i, 2);
    words[i] = static_cast<std::uint16_t>(bytes[0] << 8 | bytes[1]);
  }
}

}  // namespace

RawImage decode_netpbm(ByteReader& in) {
  if (in.u8() != 'P') throw std::runtime_error("this is not a PPM or PGM file");
  const int kind = in.u8() - '0';
  if (kind != 2 && kind != 3 && kind != 5 && kind != 6)
    throw std::runtime_error("only PGM (P2, P5) and PPM (P3, P6) are supported");
  const int width = number(in), height = number(in), maxval = number(in);
  if (maxval < 1 || maxval > 65535) throw std::runtime_error("the largest value must be 1 to 65535");
  RawImage raw;
  raw.set_size(width, height);
  raw.channels = kind == 2 || kind == 5 ? 1 : 3;
  raw.bits = maxval > 255 ? 16 : 8;
  raw.white = static_cast<float>(maxval);
  const std::size_t count = raw.pixels() * static_cast<std::size_t>(raw.channels);
  const bool binary = kind >= 5;
  // Every sample takes at least a byte (binary) or two (text): refuse before allocating.
  if (in.left() + 1 < count * (binary ? static_cast<std::size_t>(raw.bits / 8) : 2))
    throw std::runtime_error("unexpected end of file");
  if (!binary) {
    raw.allocate(SampleType::real);  // numbers may be larger than maxval, and than any word
    float* samples = raw.samples.as<float>();
    for (std::size_t i = 0; i < count; ++i) samples[i] = static_cast<float>(number(in)) / raw.white;
    return raw;
  }
  raw.allocate(raw.bits == 16 ? SampleType::word : SampleType::byte);
  in.read(raw.samples.as<void>(), raw.samples.memory());
  if (raw.bits == 16) words_from_big_endian(raw.samples.as<std::uint16_t>(), count);
  return raw;
}

}  // namespace verisim::image
