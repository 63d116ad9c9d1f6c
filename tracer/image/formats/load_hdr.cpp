// Radiance HDR. POV-Ray adds half a step to each mantissa and ignores EXPOSURE (spec 05 section 12.1).
#include <cmath>
#include <stdexcept>
#include <string>

#include "tracer/image/formats/byte_reader.h"
#include "tracer/image/formats/raw_image.h"

namespace verisim::image {
namespace {

std::string line(ByteReader& in) {
  std::string text;
  for (char c; (c = static_cast<char>(in.u8())) != '\n';) {
    text += c;
    if (text.size() > 4096) throw std::runtime_error("bad header");
  }
  return text;
}

// One row of width * 4 bytes: run-length coded by component, or plain pixels with the old repeat marks.
void read_row(ByteReader& in, int width, std::vector<std::uint8_t>& row) {
  const std::size_t start = in.position();
  const auto head = in.take(4);
  if (head[0] == 2 && head[1] == 2 && (head[2] << 8 | head[3]) == width && width >= 8 && width < 32768) {
    for (int k = 0; k < 4; ++k)
      for (int x = 0; x < width;) {
        int count = in.u8();
        const bool run = count > 128;
        if (run) count -= 128;
        if (count == 0 || x + count > width) throw std::runtime_error("bad run");
        if (run) {
          const std::uint8_t v = in.u8();
          for (; count > 0; --count) row[static_cast<std::size_t>(x++) * 4 + k] = v;
        } else {
          for (; count > 0; --count) row[static_cast<std::size_t>(x++) * 4 + k] = in.u8();
        }
      }
    return;
  }
  in.seek(start);
  int shift = 0;
  for (int x = 0; x < width;) {
    const auto p = in.take(4);
    if (p[0] == 1 && p[1] == 1 && p[2] == 1 && x > 0) {
      if (shift > 16) throw std::runtime_error("bad run");
      for (int count = p[3] << shift; count > 0 && x < width; --count, ++x)
        std::copy_n(&row[static_cast<std::size_t>(x - 1) * 4], 4, &row[static_cast<std::size_t>(x) * 4]);
      shift += 8;
    } else {
      std::copy(p.begin(), p.end(), &row[static_cast<std::size_t>(x++) * 4]);
      shift = 0;
    }
  }
}

}  // namespace

RawImage decode_hdr(ByteReader& in) {
  if (line(in).rfind("#?", 0) != 0) throw std::runtime_error("this is not a Radiance HDR file");
  while (!line(in).empty()) continue;
  const std::string size = line(in);
  int width = 0, height = 0;
  if (std::sscanf(size.c_str(), "-Y %9d +X %9d", &height, &width) != 2)
    throw std::runtime_error("only the usual orientation (-Y +X) is supported");
  RawImage raw;
  raw.set_size(width, height);
  // A run of 127 pixels takes two bytes for each of four components.
  if (static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) > in.left() * 65536)
    throw std::runtime_error("unexpected end of file");
  raw.bits = 32;
  raw.channels = 3;
  raw.allocate(SampleType::real);
  float* to = raw.samples.as<float>();
  std::vector<std::uint8_t> row(static_cast<std::size_t>(width) * 4);
  for (int y = 0; y < height; ++y) {
    read_row(in, width, row);
    for (int x = 0; x < width; ++x) {
      const std::uint8_t* p = &row[static_cast<std::size_t>(x) * 4];
      for (int k = 0; k < 3; ++k) *to++ = p[3] == 0 ? 0.0f : std::ldexp(static_cast<float>(p[k]) + 0.5f, p[3] - 136);
    }
  }
  return raw;
}

}  // namespace verisim::image
