// An image in memory as patterns, height fields and functions read it (spec 05 section 12, 02 section 5).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tracer/math/color.h"

namespace verisim {

enum class ImageType : std::uint8_t { unknown, gif, tga, png, jpeg, tiff, bmp, ppm, pgm, exr, hdr, iff, pot, sys };

class Image {
 public:
  int width = 0, height = 0;
  ImageType type = ImageType::unknown;  // of the file; unknown: made by a function
  bool grey = false;                    // one channel in the file
  bool sixteen_bit = false;
  bool has_alpha = false;  // transparency of any kind
  bool premultiplied = false;
  std::vector<Color> palette;  // with `indices`: a palette image; t = 1 - alpha
  std::vector<std::uint8_t> indices;
  std::vector<float> pixels;  // otherwise: 4 floats each, r g b and transmit, in the working space; row 0 is the top

  bool indexed() const { return !palette.empty(); }
  // Pixel with 0 <= x < width and 0 <= y < height.
  Color at(int x, int y) const {
    const std::size_t i = static_cast<std::size_t>(y) * width + x;
    if (indexed()) return palette[indices[i]];
    const float* p = &pixels[4 * i];
    return {p[0], p[1], p[2], 0, p[3]};
  }
};

enum class ImageGamma : std::uint8_t { automatic, power, srgb };

// How the values of a file become working-space values (spec 02 section 5).
struct ImageDecoding {
  ImageGamma gamma = ImageGamma::automatic;  // the `gamma` keyword after the file name
  double gamma_value = 1;
  int premultiplied = -1;  // the `premultiplied` keyword; -1: the format's own convention
  bool data = false;       // raw values: height_field, bump_map, image_pattern, material_map
  int version = 370;       // effective #version
  bool working_is_srgb = false, working_none = false;  // assumed_gamma srgb; no gamma handling at all (spec 02 4.1)
  double working_gamma = 1;
};

// Throws std::runtime_error with a message for users (missing, corrupt, too large).
std::shared_ptr<const Image> load_image(const std::filesystem::path& path, ImageType type,
                                        const ImageDecoding& decoding);
ImageType image_type_from_extension(const std::string& path);

}  // namespace verisim
