// Image files become images in the working space: decoding by format, gamma, alpha (spec 05 section 12.1, 02 section
// 5).
#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <half.h>

#include "tracer/image/gamma.h"
#include "tracer/image/in_memory.h"
#include "tracer/image/formats/raw_image.h"
#include "tracer/image/shared_files.h"

namespace verisim {
namespace image {

void RawImage::set_size(std::int64_t w, std::int64_t h) {
  if (w <= 0 || h <= 0) throw std::runtime_error("the image has no pixels");
  if (w > 0x7fffffff || h > 0x7fffffff || static_cast<std::uint64_t>(w) * static_cast<std::uint64_t>(h) > kMaxPixels)
    throw std::runtime_error("the image is too large");
  width = static_cast<int>(w);
  height = static_cast<int>(h);
}

namespace {

// Fractint's continuous potential: a GIF whose left half holds the high bytes, the right half the low bytes (04
// section 5.1).
RawImage decode_pot(ByteReader& in) {
  const RawImage gif = decode_gif(in);
  if (gif.width % 2 != 0) throw std::runtime_error("the width of a POT file must be even");
  RawImage raw;
  raw.set_size(gif.width / 2, gif.height);
  raw.channels = 1;
  raw.bits = 16;
  raw.white = 65535;
  raw.allocate(SampleType::word);
  const std::uint8_t* row = gif.samples.as<std::uint8_t>();
  std::uint16_t* to = raw.samples.as<std::uint16_t>();
  for (int y = 0; y < gif.height; ++y, row += gif.width)
    for (int x = 0; x < raw.width; ++x) *to++ = static_cast<std::uint16_t>(row[x] * 256 + row[x + raw.width]);
  return raw;
}

RawImage decode(const std::filesystem::path& path, ImageType type) {
  if (type == ImageType::iff) throw std::runtime_error("Unexpected EOF (POV-Ray cannot read IFF files either)");
  if (type == ImageType::unknown || type == ImageType::sys)
    throw std::runtime_error("this image format is not supported here");
  ByteReader in(path);
  switch (type) {
    case ImageType::png:
      return decode_png(in);
    case ImageType::gif:
      return decode_gif(in);
    case ImageType::pot:
      return decode_pot(in);
    case ImageType::tga:
      return decode_tga(in);
    case ImageType::bmp:
      return decode_bmp(in);
    case ImageType::hdr:
      return decode_hdr(in);
    case ImageType::jpeg:
      return decode_jpeg(in);
    case ImageType::tiff:
      return decode_with_module(path, ModuleKind::tiff);
    case ImageType::exr:
      return decode_with_module(path, ModuleKind::exr);
    default:
      return decode_netpbm(in);
  }
}

// How file values become what patterns see.
struct Conversion {
  Curve file = Curve::identity();     // to linear light
  Curve working = Curve::identity();  // from linear light
  bool folded = false;                // both are powers: one exponent
  Curve power = Curve::identity();

  bool is_identity() const { return folded ? power.is_identity() : file.is_identity() && working.is_identity(); }
  float operator()(float v) const {
    if (folded) return power.decode(v);
    if (file.is_identity() && working.is_identity()) return v;
    return working.encode(file.decode(v));
  }
};

Conversion conversion_for(const RawImage& raw, ImageType type, const ImageDecoding& d) {
  Conversion c;
  const bool linear_format = type == ImageType::hdr || type == ImageType::exr;
  bool convert = true;  // to the working space
  if (d.gamma != ImageGamma::automatic) {
    c.file = d.gamma == ImageGamma::srgb ? Curve::srgb() : Curve::power(d.gamma_value);
    convert = !d.data;
  } else if (d.data) {
    return c;
  } else if (d.working_none) {
    return c;
  } else if (linear_format) {
    c.file = Curve::identity();
  } else if (type == ImageType::png && raw.curve != RawImage::Curve::unspecified) {
    c.file = raw.curve == RawImage::Curve::srgb ? Curve::srgb() : Curve::power(raw.gamma);
  } else if (d.version < 370 || type == ImageType::ppm || type == ImageType::pgm || type == ImageType::tiff ||
             type == ImageType::pot) {
    return c;  // the values are working-space values already
  } else {
    c.file = Curve::srgb();
  }
  if (!convert || d.working_none) return c;
  c.working = d.working_is_srgb ? Curve::srgb() : Curve::power(d.working_gamma);
  if (c.file.is_srgb() && c.working.is_srgb()) c.file = c.working = Curve::identity();
  if (c.file.is_power() && c.working.is_power()) {
    c.folded = true;
    c.power = Curve::power(static_cast<double>(c.file.gamma()) / c.working.gamma());
  }
  return c;
}

// POV-Ray keeps greyscale PNGs of up to 8 bits in 8 bits: the value is truncated after decoding, by way of a grey sum
// in single precision that loses a step at 84 of 256 levels (04 section 5.1).
float requantised(float v) {
  const float sum = (v * 0.297f + v * 0.589f) + v * 0.114f;
  return std::floor(std::clamp(sum, 0.0f, 1.0f) * 255.0f) / 255.0f;
}

// The value in the working space and the transmit of every code.
void make_tables(const RawImage& raw, const Conversion& convert, Image& image) {
  const std::size_t codes = raw.samples.type() == SampleType::byte ? 256 : 65536;
  const auto stored = [&](std::size_t code) {
    if (raw.samples.type() == SampleType::half) return imath_half_to_float(static_cast<std::uint16_t>(code));
    return static_cast<float>(code) / raw.white;
  };
  const auto table = [&](const auto& of_code) {
    auto made = std::make_shared<std::vector<float>>(codes);
    for (std::size_t i = 0; i < codes; ++i) (*made)[i] = of_code(stored(i));
    return made;
  };
  image.values = table([&](float v) { return raw.grey8 ? requantised(convert(v)) : convert(v); });
  if (image.has_alpha) image.transmits = table([](float v) { return 1 - v; });
}

// Reals have no tables.
void convert_reals(RawImage& raw, const Conversion& convert, bool has_alpha) {
  float* p = raw.samples.as<float>();
  const auto n = static_cast<std::size_t>(raw.channels), colors = has_alpha ? n - 1 : n;
  if (convert.is_identity() && !has_alpha) return;
  for (const float* const end = p + raw.samples.size(); p != end; p += n) {
    for (std::size_t k = 0; k < colors; ++k) p[k] = convert(p[k]);
    if (has_alpha) p[n - 1] = 1 - p[n - 1];
  }
}

// Straight alpha in a TIFF: libtiff, through which POV-Ray reads, multiplies 8-bit colours by it and rounds.
// `value` and `sample` convert a sample to a fraction of white and back.
template <class T, class Value, class Sample>
void multiply_alpha(RawImage& raw, float steps, const Value& value, const Sample& sample) {
  T* p = raw.samples.as<T>();
  const auto n = static_cast<std::size_t>(raw.channels);
  for (const T* const end = p + raw.samples.size(); p != end; p += n)
    for (std::size_t k = 0; k + 1 < n; ++k) p[k] = sample(std::floor(value(p[k]) * value(p[n - 1]) * steps + 0.5f));
}
void multiply_alpha(RawImage& raw) {
  const auto of_code = [&](auto code) { return static_cast<float>(code) / raw.white; };
  constexpr float kSteps = 65535;
  switch (raw.samples.type()) {
    case SampleType::byte:
      multiply_alpha<std::uint8_t>(raw, 255, of_code, [](float v) { return static_cast<std::uint8_t>(v); });
      break;
    case SampleType::word:
      multiply_alpha<std::uint16_t>(raw, kSteps, of_code, [](float v) { return static_cast<std::uint16_t>(v); });
      break;
    default:
      multiply_alpha<float>(
          raw, kSteps, [](float v) { return v; }, [](float v) { return v / kSteps; });
      break;
  }
}

void make_palette(const RawImage& raw, const Conversion& convert, Image& image) {
  for (std::size_t i = 0; i < raw.palette.size() / 4; ++i) {
    const float* rgba = &raw.palette[4 * i];
    image.palette.emplace_back(convert(rgba[0]), convert(rgba[1]), convert(rgba[2]), 0.0f, 1 - rgba[3]);
  }
  // Files may use entries that their palette lacks.
  const std::uint8_t* indices = raw.samples.as<std::uint8_t>();
  const std::uint8_t highest = *std::max_element(indices, indices + raw.samples.size());
  if (image.palette.size() <= highest) image.palette.resize(std::size_t{highest} + 1);
}

std::shared_ptr<const Image> finish(RawImage raw, ImageType type, const ImageDecoding& d) {
  auto image = std::make_shared<Image>();
  image->width = raw.width;
  image->height = raw.height;
  image->grey = raw.channels <= 2 && raw.palette.empty();
  image->sixteen_bit = raw.bits == 16;
  image->has_alpha = raw.channels == 2 || raw.channels == 4;
  image->premultiplied = image->has_alpha && (d.premultiplied >= 0 ? d.premultiplied != 0
                                                                   : type == ImageType::exr || type == ImageType::tiff);
  const Conversion convert = conversion_for(raw, type, d);
  if (!raw.palette.empty()) {
    image->channels = 1;
    make_palette(raw, convert, *image);
  } else {
    image->channels = raw.channels;
    if (type == ImageType::tiff && image->premultiplied && !raw.premultiplied && d.premultiplied < 0)
      multiply_alpha(raw);
    if (raw.samples.type() == SampleType::real)
      convert_reals(raw, convert, image->has_alpha);
    else
      make_tables(raw, convert, *image);
  }
  image->samples = std::move(raw.samples);
  return image;
}

}  // namespace

std::shared_ptr<const Image> make_image(const PixelArray& pixels, const ImageDecoding& decoding) {
  RawImage raw;
  raw.set_size(pixels.width, pixels.height);
  if (pixels.channels < 1 || pixels.channels > 4) throw std::runtime_error("an image has 1 to 4 samples a pixel");
  raw.channels = pixels.channels;
  const std::size_t count = raw.pixels() * static_cast<std::size_t>(raw.channels);
  if (pixels.samples.size() != count) throw std::runtime_error("the samples of an image do not fit its size");
  switch (pixels.samples.type()) {
    case SampleType::byte:
      raw.samples = pixels.samples;
      raw.grey8 = raw.channels == 1;
      return finish(std::move(raw), ImageType::png, decoding);
    case SampleType::word:
      raw.bits = 16;
      raw.white = 65535;
      raw.samples = pixels.samples;
      return finish(std::move(raw), ImageType::png, decoding);
    case SampleType::real: {
      raw.bits = 32;
      raw.allocate(SampleType::real);  // of its own: the values are converted in place
      const float* from = pixels.samples.as<float>();
      std::copy(from, from + count, raw.samples.as<float>());
      return finish(std::move(raw), ImageType::hdr, decoding);
    }
    default:
      throw std::runtime_error("an image in memory has samples of 8 or 16 bits, or floats");
  }
}

}  // namespace image

std::shared_ptr<const Image> load_image(const std::filesystem::path& path, ImageType type,
                                        const ImageDecoding& decoding) {
  if (type == ImageType::unknown) type = image_type_from_extension(path.string());
  static image::SharedFiles<Image> files;
  const ImageDecoding& d = decoding;
  std::ostringstream how;
  how << std::hexfloat << static_cast<int>(type) << ' ' << static_cast<int>(d.gamma) << ' ' << d.gamma_value << ' '
      << d.premultiplied << ' ' << d.data << ' ' << d.version << ' ' << d.working_is_srgb << ' ' << d.working_none
      << ' ' << d.working_gamma;
  try {
    return files.get(path, how.str(), [&] { return image::finish(image::decode(path, type), type, decoding); });
  } catch (const std::bad_alloc&) {
    throw std::runtime_error(path.string() + ": not enough memory for the image");
  } catch (const std::exception& e) {
    throw std::runtime_error(path.string() + ": " + e.what());
  }
}

ImageType image_type_from_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static constexpr std::pair<const char*, ImageType> kKnown[] = {
      {".gif", ImageType::gif},   {".tga", ImageType::tga},  {".png", ImageType::png},   {".jpg", ImageType::jpeg},
      {".jpeg", ImageType::jpeg}, {".tif", ImageType::tiff}, {".tiff", ImageType::tiff}, {".bmp", ImageType::bmp},
      {".ppm", ImageType::ppm},   {".pgm", ImageType::pgm},  {".exr", ImageType::exr},   {".hdr", ImageType::hdr},
      {".iff", ImageType::iff},   {".pot", ImageType::pot},  {".sys", ImageType::sys},
  };
  for (const auto& [name, type] : kKnown)
    if (extension == name) return type;
  return ImageType::unknown;
}

}  // namespace verisim
