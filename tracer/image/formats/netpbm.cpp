#include "tracer/image/formats/netpbm.h"

#include <cctype>
#include <stdexcept>

#include "tracer/image/formats/raw_image.h"

namespace verisim::image {
namespace {

// The next number of a header or of a plain picture; comments run from # to the end of the line.
long read_number(std::FILE* file, long limit) {
  int c = std::fgetc(file);
  while (c == '#' || std::isspace(c)) {
    if (c == '#')
      while (c != '\n' && c != EOF) c = std::fgetc(file);
    c = std::fgetc(file);
  }
  if (!std::isdigit(c)) throw std::runtime_error("not a valid netpbm file");
  long value = 0;
  while (std::isdigit(c)) {
    value = value * 10 + (c - '0');
    if (value > limit) throw std::runtime_error("a number in the netpbm file is too large");
    c = std::fgetc(file);
  }
  return value;
}

}  // namespace

void write_ppm(std::FILE* file, const Quantised& picture, const OutputOptions& options) {
  std::fprintf(file, "P%d\n", picture.channels == 1 ? 5 : 6);
  for (const auto& [key, value] : options.metadata) {
    std::string line = key + ": " + value;
    for (char& c : line)
      if (c == '\n' || c == '\r') c = ' ';
    std::fprintf(file, "# %s\n", line.c_str());
  }
  std::fprintf(file, "%d %d\n%d\n", picture.width, picture.height, (1 << picture.bits) - 1);
  // Greyscale samples take two bytes whatever maxval says, as POV-Ray writes them (spec 02 section 4.6).
  const bool wide = picture.bits > 8 || options.greyscale;
  std::vector<unsigned char> row;
  const std::size_t per_row = static_cast<std::size_t>(picture.width) * picture.channels;
  for (int y = 0; y < picture.height; ++y) {
    row.clear();
    for (std::size_t i = 0; i < per_row; ++i) {
      const std::uint16_t v = picture.samples[per_row * y + i];
      if (wide) row.push_back(static_cast<unsigned char>(v >> 8));
      row.push_back(static_cast<unsigned char>(v & 255));
    }
    if (std::fwrite(row.data(), 1, row.size(), file) != row.size()) throw std::runtime_error("cannot write");
  }
}

Picture read_netpbm(std::FILE* file) {
  const int p = std::fgetc(file), kind = std::fgetc(file);
  if (p != 'P' || (kind != '2' && kind != '3' && kind != '5' && kind != '6'))
    throw std::runtime_error("not a PPM or PGM file");
  Picture picture;
  picture.channels = kind == '2' || kind == '5' ? 1 : 3;
  picture.width = static_cast<int>(read_number(file, kMaxSide));
  picture.height = static_cast<int>(read_number(file, kMaxSide));
  const long max_value = read_number(file, 65535);
  if (picture.width == 0 || picture.height == 0 || max_value == 0) throw std::runtime_error("not a valid netpbm file");
  const std::size_t count = static_cast<std::size_t>(picture.width) * picture.height * picture.channels;
  if (count > kMaxSamples) throw std::runtime_error("the picture is too large");
  picture.bits = max_value > 255 ? 16 : 8;
  const float scale = 1.0f / static_cast<float>(max_value);
  // Grows as the data come, so that a short file cannot claim much memory.
  for (std::size_t i = 0; i < count; ++i) {
    long value;
    if (kind <= '3') {
      value = read_number(file, 65535);
    } else {
      const int high = max_value > 255 ? std::fgetc(file) : 0, low = std::fgetc(file);
      if (high == EOF || low == EOF) throw std::runtime_error("the file ends too early");
      value = high << 8 | low;
    }
    picture.samples.push_back(static_cast<float>(value) * scale);
  }
  return picture;
}

}  // namespace verisim::image
