// GIF: the first picture, as palette and indices (spec 05 section 12.1).
#include <array>
#include <stdexcept>

#include "tracer/image/byte_reader.h"
#include "tracer/image/raw_image.h"

namespace verisim::image {
namespace {

// The data of a chain of sub-blocks.
std::vector<std::uint8_t> sub_blocks(ByteReader& in) {
  std::vector<std::uint8_t> data;
  for (std::uint8_t n; (n = in.u8()) != 0;) {
    const auto block = in.take(n);
    data.insert(data.end(), block.begin(), block.end());
  }
  return data;
}

void read_palette(ByteReader& in, int count, std::vector<float>& palette) {
  palette.clear();
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) palette.push_back(static_cast<float>(in.u8()) / 255.0f);
    palette.push_back(1);
  }
}

// Lempel-Ziv-Welch with growing codes; each code is a suffix byte and a link to its prefix.
void unpack_lzw(const std::vector<std::uint8_t>& data, int root_bits, std::vector<std::uint8_t>& out,
                std::size_t wanted) {
  if (root_bits < 1 || root_bits > 8) throw std::runtime_error("bad code size");
  const int clear = 1 << root_bits, end = clear + 1;
  std::array<std::uint16_t, 4096> prefix{};
  std::array<std::uint8_t, 4096> suffix{}, stack{};
  int next = end + 1, bits = root_bits + 1, previous = -1;
  std::uint8_t first = 0;
  std::uint32_t buffer = 0;
  int available = 0;
  std::size_t position = 0;
  while (out.size() < wanted) {
    while (available < bits) {
      if (position == data.size()) throw std::runtime_error("unexpected end of the picture");
      buffer |= static_cast<std::uint32_t>(data[position++]) << available;
      available += 8;
    }
    const int code = static_cast<int>(buffer & ((1u << bits) - 1));
    buffer >>= bits;
    available -= bits;
    if (code == clear) {
      next = end + 1;
      bits = root_bits + 1;
      previous = -1;
      continue;
    }
    if (code == end) throw std::runtime_error("unexpected end of the picture");
    if (code > next || (code == next && previous < 0)) throw std::runtime_error("bad code");
    int depth = 0, at = code;
    if (code == next) {
      stack[depth++] = first;
      at = previous;
    }
    for (; at > end; at = prefix[at]) stack[depth++] = suffix[at];
    first = static_cast<std::uint8_t>(at);
    stack[depth++] = first;
    while (depth > 0 && out.size() < wanted) out.push_back(stack[--depth]);
    if (previous >= 0 && next < 4096) {
      prefix[next] = static_cast<std::uint16_t>(previous);
      suffix[next] = first;
      if (++next == 1 << bits && bits < 12) ++bits;
    }
    previous = code;
  }
}

}  // namespace

RawImage decode_gif(const std::vector<std::uint8_t>& file) {
  ByteReader in(file);
  const auto magic = in.take(6);
  if (magic[0] != 'G' || magic[1] != 'I' || magic[2] != 'F') throw std::runtime_error("this is not a GIF file");
  in.skip(4);  // size of the screen
  const int flags = in.u8();
  in.skip(2);
  RawImage raw;
  if (!(flags & 0x80)) throw std::runtime_error("a GIF without global palette is not supported");
  read_palette(in, 2 << (flags & 7), raw.palette);
  raw.channels = 3;
  int transparent = -1;
  for (;;) {
    const int kind = in.u8();
    if (kind == 0x21) {
      const int label = in.u8();
      const std::vector<std::uint8_t> data = sub_blocks(in);
      if (label == 0xf9 && data.size() >= 4 && (data[0] & 1)) transparent = data[3];
    } else if (kind == 0x2c) {
      break;
    } else {
      throw std::runtime_error("no picture in the GIF file");
    }
  }
  in.skip(4);  // position on the screen
  const int width = in.le16(), height = in.le16(), picture_flags = in.u8();
  if (picture_flags & 0x40) throw std::runtime_error("an interlaced GIF is not supported");
  if (picture_flags & 0x80) read_palette(in, 2 << (picture_flags & 7), raw.palette);
  raw.set_size(width, height);
  const int root_bits = in.u8();
  const std::vector<std::uint8_t> data = sub_blocks(in);
  const std::size_t count = static_cast<std::size_t>(width) * height;
  if (count > data.size() * 4096)
    throw std::runtime_error("unexpected end of the picture");  // a code is at least 2 bits and at most 4096 pixels
  raw.indices.reserve(count);
  unpack_lzw(data, root_bits, raw.indices, count);
  if (transparent >= 0 && 4 * static_cast<std::size_t>(transparent) < raw.palette.size()) {
    raw.channels = 4;
    raw.palette[4 * static_cast<std::size_t>(transparent) + 3] = 0;
  }
  return raw;
}

}  // namespace verisim::image
