// An image in memory as patterns, height fields and functions read it (spec 05 section 12, 02 section 5).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tracer/image/samples.h"
#include "tracer/math/color.h"

namespace verisim {

enum class ImageType : std::uint8_t { unknown, gif, tga, png, jpeg, tiff, bmp, ppm, pgm, exr, hdr, iff, pot, sys };

// Samples stay as the file stores them; tables say what its codes mean, so that a lookup needs no powers.
class Image {
 public:
  int width = 0, height = 0;
  ImageType type = ImageType::unknown;  // of the file; unknown: made by a function
  bool grey = false;                    // one channel in the file
  bool sixteen_bit = false;
  bool has_alpha = false;  // transparency of any kind
  bool premultiplied = false;
  int channels = 4;            // samples a pixel: 1 grey, 2 grey + alpha, 3 rgb, 4 rgb + alpha; an index: 1
  std::vector<Color> palette;  // of a palette image, whose samples are its indices; t = 1 - alpha
  // By code of bytes, words and halves: the value in the working space, and the transmit of an alpha of that code.
  // Reals are values in the working space, their alpha a transmit.
  using CodeTable = std::shared_ptr<const std::vector<float>>;
  CodeTable values, transmits;
  image::Samples samples;  // row 0 is the top

 private:
  std::size_t offset(int x, int y) const { return static_cast<std::size_t>(y) * width + x; }
  template <class Sample, class Value, class Transmit>
  auto reader(const Value& value, const Transmit& transmit) const {
    return [this, value, transmit, first = samples.as<Sample>(), n = static_cast<std::size_t>(channels)](int x, int y) {
      const Sample* p = first + offset(x, y) * n;
      const float t = n == 2 || n == 4 ? transmit(p[n - 1]) : 0.0f;
      if (n >= 3) return Color(value(p[0]), value(p[1]), value(p[2]), 0, t);
      const float grey_value = value(p[0]);
      return Color(grey_value, grey_value, grey_value, 0, t);
    };
  }
  template <class Code>
  auto decoder() const {
    return reader<Code>([value = values->data()](Code c) { return value[c]; },
                        [transmit = transmits ? transmits->data() : nullptr](Code c) { return transmit[c]; });
  }

 public:
  bool indexed() const { return !palette.empty(); }
  // What `use` makes of a function from x and y to a colour: for several pixels the kind of samples is asked for once.
  template <class Use>
  Color with_reader(const Use& use) const {
    if (indexed()) return use([this](int x, int y) { return palette[index(x, y)]; });
    switch (samples.type()) {
      case image::SampleType::byte:
        return use(decoder<std::uint8_t>());
      case image::SampleType::word:
      case image::SampleType::half:
        return use(decoder<std::uint16_t>());
      default:
        return use(reader<float>([](float v) { return v; }, [](float t) { return t; }));
    }
  }
  // Pixel with 0 <= x < width and 0 <= y < height.
  Color at(int x, int y) const {
    return with_reader([&](const auto& read) { return read(x, y); });
  }
  // Entry of the palette.
  std::uint8_t index(int x, int y) const { return samples.as<std::uint8_t>()[offset(x, y)]; }
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
