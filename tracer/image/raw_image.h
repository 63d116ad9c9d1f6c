// What a decoder found in an image file, before any gamma conversion (spec 05 section 12.1).
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "tracer/image/image.h"

namespace verisim::image {

// Larger pictures are refused before memory is allocated.
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 27;

struct RawImage {
  enum class Curve : std::uint8_t { unspecified, srgb, power };  // what the file itself says of its values
  int width = 0, height = 0;
  int channels = 3;    // 1 grey, 2 grey + alpha, 3 rgb, 4 rgb + alpha; of an indexed image: of its palette
  int bits = 8;        // 8, 16 or 32 (float) per sample as stored
  bool grey8 = false;  // greyscale PNG without alpha of at most 8 bits: kept in 8 bits by POV-Ray
  bool premultiplied = false;
  Curve curve = Curve::unspecified;
  double gamma = 1;            // of a power curve: linear = value ^ gamma
  std::vector<float> samples;  // channels values per pixel, 1 = white; row 0 is the top
  std::vector<float> palette;  // 4 floats each: r g b alpha
  std::vector<std::uint8_t> indices;

  // Throws std::runtime_error when the size is nothing or too much.
  void set_size(std::int64_t w, std::int64_t h);
};

// The file in memory; throws std::runtime_error when it cannot be read.
std::vector<std::uint8_t> read_file(const std::filesystem::path& path);

// Decoders; all throw std::runtime_error on anything that is not a whole picture of that format.
RawImage decode_png(const std::vector<std::uint8_t>& file);
RawImage decode_netpbm(const std::vector<std::uint8_t>& file);
RawImage decode_gif(const std::vector<std::uint8_t>& file);
RawImage decode_tga(const std::vector<std::uint8_t>& file);
RawImage decode_bmp(const std::vector<std::uint8_t>& file);
RawImage decode_hdr(const std::vector<std::uint8_t>& file);
RawImage decode_with_module(const std::filesystem::path& path);  // JPEG, TIFF, EXR through OpenImageIO

}  // namespace verisim::image
