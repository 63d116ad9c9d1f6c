// Windows bitmaps: 1, 4 and 8 bits with palette (also run-length coded), 24 and 32 bits.
#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "tracer/image/formats/byte_reader.h"
#include "tracer/image/formats/raw_image.h"

namespace verisim::image {
namespace {

// Run-length coding of 8 (or 4) bits per pixel into rows from the bottom up.
void unpack_runs(ByteReader& in, bool four_bits, RawImage& raw) {
  std::uint8_t* indices = raw.allocate_indices();
  std::fill_n(indices, raw.pixels(), std::uint8_t{0});  // runs may leave pixels out
  int x = 0, y = 0;
  const auto put = [&](int v) {
    if (x < raw.width && y < raw.height)
      indices[static_cast<std::size_t>(raw.height - 1 - y) * raw.width + x] = static_cast<std::uint8_t>(v);
    ++x;
  };
  while (y < raw.height) {
    const int count = in.u8(), value = in.u8();
    if (count > 0) {
      for (int i = 0; i < count; ++i) put(four_bits ? (i & 1 ? value & 15 : value >> 4) : value);
    } else if (value == 0) {
      x = 0;
      ++y;
    } else if (value == 1) {
      return;
    } else if (value == 2) {
      x += in.u8();
      y += in.u8();
    } else {
      const int bytes = four_bits ? (value + 1) / 2 : value;
      const auto data = in.take(static_cast<std::size_t>(bytes + (bytes & 1)));
      for (int i = 0; i < value; ++i) put(four_bits ? (i & 1 ? data[i / 2] & 15 : data[i / 2] >> 4) : data[i]);
    }
  }
}

}  // namespace

RawImage decode_bmp(ByteReader& in) {
  if (in.u8() != 'B' || in.u8() != 'M') throw std::runtime_error("this is not a BMP file");
  in.skip(8);
  const std::uint32_t data_offset = in.le32(), header = in.le32();
  const bool old = header == 12;
  if (!old && header < 40) throw std::runtime_error("unknown header in the BMP file");
  const std::int64_t width = old ? in.le16() : static_cast<std::int32_t>(in.le32());
  const std::int64_t signed_height = old ? in.le16() : static_cast<std::int32_t>(in.le32());
  in.skip(2);
  const int bits = in.le16();
  std::uint32_t compression = 0, colors = 0;
  if (!old) {
    compression = in.le32();
    in.skip(12);
    colors = in.le32();
  }
  RawImage raw;
  raw.set_size(width, std::abs(signed_height));
  const bool runs = (compression == 1 && bits == 8) || (compression == 2 && bits == 4);
  if (compression != 0 && !runs) throw std::runtime_error("this compression of BMP files is not supported");
  const bool indexed = bits == 1 || bits == 4 || bits == 8;
  if (!indexed && bits != 24 && bits != 32)
    throw std::runtime_error("this number of bits in a BMP file is not supported");
  const auto w = static_cast<std::size_t>(raw.width), h = static_cast<std::size_t>(raw.height);
  if (indexed) {
    in.seek(14 + static_cast<std::size_t>(header));
    const std::size_t count = colors != 0 && colors <= 256 ? colors : std::size_t{1} << bits;
    for (std::size_t i = 0; i < count; ++i) {
      const auto entry = in.take(old ? 3 : 4);
      for (int k = 0; k < 3; ++k) raw.palette.push_back(static_cast<float>(entry[2 - k]) / 255.0f);
      raw.palette.push_back(1);
    }
  }
  raw.channels = bits == 32 ? 4 : 3;
  in.seek(data_offset);
  if (runs) {
    unpack_runs(in, bits == 4, raw);
    return raw;
  }
  const std::size_t row_bytes = (w * static_cast<std::size_t>(bits) + 31) / 32 * 4;
  if (in.left() + 3 < row_bytes * h) throw std::runtime_error("unexpected end of file");
  if (indexed)
    raw.allocate_indices();
  else
    raw.allocate(SampleType::byte);
  const std::size_t n = indexed ? 1 : static_cast<std::size_t>(raw.channels);
  for (std::size_t row = 0; row < h; ++row) {
    const auto data = in.take(std::min(row_bytes, in.left()));
    if (data.size() * 8 < w * static_cast<std::size_t>(bits)) throw std::runtime_error("unexpected end of file");
    std::uint8_t* to = raw.samples.as<std::uint8_t>() + (signed_height < 0 ? row : h - 1 - row) * w * n;
    for (std::size_t x = 0; x < w; ++x, to += n) {
      if (indexed) {
        const std::size_t bit = x * static_cast<std::size_t>(bits);
        *to = static_cast<std::uint8_t>(data[bit / 8] >> (8 - bits - static_cast<int>(bit % 8)) & ((1 << bits) - 1));
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) to[k] = data[x * n + 2 - k];
      if (n == 4) to[3] = data[x * n + 3];
    }
  }
  return raw;
}

}  // namespace verisim::image
