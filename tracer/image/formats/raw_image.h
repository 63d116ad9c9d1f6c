// What a decoder found in an image file, before any gamma conversion (spec 05 section 12.1).
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tracer/image/formats/byte_reader.h"
#include "tracer/image/image.h"
#include "tracer/image/module/module.h"

namespace verisim::image {

// Larger pictures are refused before memory is allocated.
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 27;
// The same of pictures that are compared or looked at.
inline constexpr std::uint64_t kMaxStoredPixels = std::uint64_t{1} << 29;

// The same of PNG and Netpbm files that are compared.
inline constexpr std::uint32_t kMaxSide = 1u << 20;
inline constexpr std::size_t kMaxSamples = std::size_t{1} << 31;

struct RawImage {
  enum class Curve : std::uint8_t { unspecified, srgb, power };  // what the file itself says of its values
  int width = 0, height = 0;
  int channels = 3;    // 1 grey, 2 grey + alpha, 3 rgb, 4 rgb + alpha; of an indexed image: of its palette
  int bits = 8;        // 8, 16 or 32 (float) per sample as stored
  bool grey8 = false;  // greyscale PNG without alpha of at most 8 bits: kept in 8 bits by POV-Ray
  bool premultiplied = false;
  Curve curve = Curve::unspecified;
  double gamma = 1;            // of a power curve: linear = value ^ gamma
  float white = 255;           // the byte or word that means 1
  Samples samples;             // channels values per pixel, or one index of the palette; row 0 is the top
  std::vector<float> palette;  // 4 floats each: r g b alpha

  // Throws std::runtime_error when the size is nothing or too much.
  void set_size(std::int64_t w, std::int64_t h);
  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  // Memory for all samples, not cleared.
  void allocate(SampleType type) { samples = Samples(type, pixels() * static_cast<std::size_t>(channels)); }
  std::uint8_t* allocate_indices() {
    samples = Samples(SampleType::byte, pixels());
    return samples.as<std::uint8_t>();
  }
};

// Decoders; all throw std::runtime_error on anything that is not a whole picture of that format.
RawImage decode_png(ByteReader& in);
RawImage decode_netpbm(ByteReader& in);
RawImage decode_gif(ByteReader& in);
RawImage decode_tga(ByteReader& in);
RawImage decode_bmp(ByteReader& in);
RawImage decode_hdr(ByteReader& in);
RawImage decode_jpeg(ByteReader& in);
RawImage decode_with_module(const std::filesystem::path& path, ModuleKind kind);

}  // namespace verisim::image
