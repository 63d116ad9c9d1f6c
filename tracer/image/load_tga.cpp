// Targa: palette, grey and true colour, plain or run-length coded.
#include <algorithm>
#include <stdexcept>

#include "tracer/image/byte_reader.h"
#include "tracer/image/raw_image.h"

namespace verisim::image {
namespace {

// One pixel as r g b a; 15 and 16 bits are 5 bits each.
void put_color(const std::uint8_t* p, int bytes, float* rgba) {
  rgba[3] = 1;
  if (bytes == 2) {
    const int v = p[0] | p[1] << 8;
    for (int k = 0; k < 3; ++k) rgba[k] = static_cast<float>((v >> (10 - 5 * k) & 31) * 255 / 31) / 255.0f;
    return;
  }
  for (int k = 0; k < 3; ++k) rgba[k] = static_cast<float>(p[2 - k]) / 255.0f;
  if (bytes == 4) rgba[3] = static_cast<float>(p[3]) / 255.0f;
}

std::vector<std::uint8_t> unpack(ByteReader& in, std::size_t count, std::size_t bytes, bool packed) {
  if (!packed) {
    const auto data = in.take(count * bytes);
    return {data.begin(), data.end()};
  }
  if (count > in.left() * 128) throw std::runtime_error("unexpected end of file");
  std::vector<std::uint8_t> out;
  out.reserve(count * bytes);
  while (out.size() < count * bytes) {
    const int code = in.u8();
    const std::size_t n = std::min<std::size_t>((code & 127) + 1, count - out.size() / bytes);
    if (code & 128) {
      const auto pixel = in.take(bytes);
      for (std::size_t i = 0; i < n; ++i) out.insert(out.end(), pixel.begin(), pixel.end());
    } else {
      const auto pixels = in.take(n * bytes);
      out.insert(out.end(), pixels.begin(), pixels.end());
    }
  }
  return out;
}

}  // namespace

RawImage decode_tga(const std::vector<std::uint8_t>& file) {
  ByteReader in(file);
  const int id_length = in.u8(), has_palette = in.u8(), type = in.u8();
  const int palette_first = in.le16(), palette_count = in.le16(), palette_bits = in.u8();
  in.skip(4);
  const int width = in.le16(), height = in.le16(), depth = in.u8(), descriptor = in.u8();
  const bool indexed = type == 1 || type == 9, color = type == 2 || type == 10, grey = type == 3 || type == 11;
  if (!indexed && !color && !grey) throw std::runtime_error("unknown type of TGA file");
  const bool depth_known = color ? depth == 15 || depth == 16 || depth == 24 || depth == 32 : depth == 8;
  if (!depth_known || (indexed && !has_palette)) throw std::runtime_error("unknown pixel size in the TGA file");
  RawImage raw;
  raw.set_size(width, height);
  in.skip(static_cast<std::size_t>(id_length));
  if (has_palette) {
    const int bytes = (palette_bits + 7) / 8;
    if (bytes < 2 || bytes > 4) throw std::runtime_error("unknown palette in the TGA file");
    raw.palette.assign(std::min<std::size_t>(static_cast<std::size_t>(palette_first) + palette_count, 256) * 4, 0);
    for (int i = 0; i < palette_count; ++i) {
      const auto entry = in.take(static_cast<std::size_t>(bytes));
      if (palette_first + i < 256)
        put_color(entry.data(), bytes, &raw.palette[4 * static_cast<std::size_t>(palette_first + i)]);
    }
    raw.channels = bytes == 4 ? 4 : 3;
    if (!indexed) raw.palette.clear();
  }
  const std::size_t count = static_cast<std::size_t>(width) * height;
  const int bytes = (depth + 7) / 8;
  const std::vector<std::uint8_t> data = unpack(in, count, static_cast<std::size_t>(bytes), type >= 9);
  const bool from_top = descriptor & 0x20, from_right = descriptor & 0x10;
  if (!indexed) raw.channels = grey ? 1 : depth == 32 ? 4 : 3;
  if (indexed)
    raw.indices.resize(count);
  else
    raw.samples.resize(count * static_cast<std::size_t>(raw.channels));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::uint8_t* p = &data[(static_cast<std::size_t>(y) * width + x) * bytes];
      const std::size_t to =
          static_cast<std::size_t>(from_top ? y : height - 1 - y) * width + (from_right ? width - 1 - x : x);
      if (indexed) {
        raw.indices[to] = *p;
      } else if (grey) {
        raw.samples[to] = static_cast<float>(*p) / 255.0f;
      } else {
        float rgba[4];
        put_color(p, bytes, rgba);
        for (int k = 0; k < raw.channels; ++k) raw.samples[to * raw.channels + k] = rgba[k];
      }
    }
  return raw;
}

}  // namespace verisim::image
