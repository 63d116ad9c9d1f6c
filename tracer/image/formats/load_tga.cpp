// Targa: palette, grey and true colour, plain or run-length coded.
#include <algorithm>
#include <stdexcept>

#include "tracer/image/formats/byte_reader.h"
#include "tracer/image/formats/raw_image.h"

namespace verisim::image {
namespace {

// One pixel as r g b a; 15 and 16 bits are 5 bits each.
void put_color(const std::uint8_t* p, int bytes, std::uint8_t* rgba) {
  rgba[3] = 255;
  if (bytes == 2) {
    const int v = p[0] | p[1] << 8;
    for (int k = 0; k < 3; ++k) rgba[k] = static_cast<std::uint8_t>((v >> (10 - 5 * k) & 31) * 255 / 31);
    return;
  }
  for (int k = 0; k < 3; ++k) rgba[k] = p[2 - k];
  if (bytes == 4) rgba[3] = p[3];
}

// Pixels one after the other, plain or in packets that repeat one or hold several.
class Pixels {
 public:
  Pixels(ByteReader& in, std::size_t bytes, bool packed) : in_(in), bytes_(bytes), packed_(packed) {}
  const std::uint8_t* next() {
    if (!packed_) return in_.take(bytes_).data();
    if (left_ == 0) {
      const int code = in_.u8();
      left_ = (code & 127) + 1;
      repeated_ = code & 128;
      if (repeated_) in_.read(pixel_, bytes_);
    }
    --left_;
    return repeated_ ? pixel_ : in_.take(bytes_).data();
  }

 private:
  ByteReader& in_;
  std::size_t bytes_;
  bool packed_, repeated_ = false;
  int left_ = 0;
  std::uint8_t pixel_[4] = {};
};

}  // namespace

RawImage decode_tga(ByteReader& in) {
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
      if (palette_first + i >= 256) continue;
      std::uint8_t rgba[4];
      put_color(entry.data(), bytes, rgba);
      for (int k = 0; k < 4; ++k)
        raw.palette[4 * static_cast<std::size_t>(palette_first + i) + static_cast<std::size_t>(k)] =
            static_cast<float>(rgba[k]) / 255.0f;
    }
    raw.channels = bytes == 4 ? 4 : 3;
    if (!indexed) raw.palette.clear();
  }
  const int bytes = (depth + 7) / 8;
  const bool packed = type >= 9;
  // A packet of 128 pixels takes at least two bytes: refuse before allocating.
  const std::size_t least = packed ? raw.pixels() / 128 : raw.pixels() * static_cast<std::size_t>(bytes);
  if (least > in.left()) throw std::runtime_error("unexpected end of file");
  const bool from_top = descriptor & 0x20, from_right = descriptor & 0x10;
  if (!indexed) raw.channels = grey ? 1 : depth == 32 ? 4 : 3;
  if (indexed)
    raw.allocate_indices();
  else
    raw.allocate(SampleType::byte);
  const std::size_t n = bytes == 1 ? 1 : static_cast<std::size_t>(raw.channels);
  Pixels pixels(in, static_cast<std::size_t>(bytes), packed);
  for (int y = 0; y < height; ++y) {
    std::uint8_t* row = raw.samples.as<std::uint8_t>() +
                        static_cast<std::size_t>(from_top ? y : height - 1 - y) * static_cast<std::size_t>(width) * n;
    for (int x = 0; x < width; ++x) {
      const std::uint8_t* p = pixels.next();
      std::uint8_t rgba[4] = {*p};
      if (bytes > 1) put_color(p, bytes, rgba);
      std::copy_n(rgba, n, row + static_cast<std::size_t>(from_right ? width - 1 - x : x) * n);
    }
  }
  return raw;
}

}  // namespace verisim::image
