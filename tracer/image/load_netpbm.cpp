// PGM and PPM, text and binary, any maxval up to 65535.
#include <stdexcept>
#include <string>

#include "tracer/image/byte_reader.h"
#include "tracer/image/raw_image.h"

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

}  // namespace

RawImage decode_netpbm(const std::vector<std::uint8_t>& file) {
  ByteReader in(file);
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
  const std::size_t count = static_cast<std::size_t>(width) * height * raw.channels;
  const bool binary = kind >= 5;
  // Every sample takes at least a byte (binary) or two (text): refuse before allocating.
  if (in.left() + 1 < count * (binary ? static_cast<std::size_t>(raw.bits / 8) : 2))
    throw std::runtime_error("unexpected end of file");
  raw.samples.resize(count);
  for (float& sample : raw.samples) {
    int v;
    if (!binary) {
      v = number(in);
    } else if (maxval > 255) {
      v = in.u8() << 8;
      v |= in.u8();
    } else {
      v = in.u8();
    }
    sample = static_cast<float>(v) / static_cast<float>(maxval);
  }
  return raw;
}

}  // namespace verisim::image
