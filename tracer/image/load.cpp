// Image files become images in the working space: decoding by format, gamma, alpha (spec 05 section 12.1, 02 section
// 5).
#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tracer/image/gamma.h"
#include "tracer/image/raw_image.h"
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

std::vector<std::uint8_t> read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw std::runtime_error("cannot open the file");
  const std::streamoff size = file.tellg();
  if (size < 0) throw std::runtime_error("cannot read the file");
  constexpr std::streamoff kMaxFile = std::streamoff{1} << 31;
  if (size > kMaxFile) throw std::runtime_error("the file is too large");
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
  file.seekg(0);
  if (size > 0 && !file.read(reinterpret_cast<char*>(bytes.data()), size))
    throw std::runtime_error("cannot read the file");
  return bytes;
}

namespace {

// Fractint's continuous potential: a GIF whose left half holds the high bytes, the right half the low bytes (04
// section 5.1).
RawImage decode_pot(const std::vector<std::uint8_t>& file) {
  const RawImage gif = decode_gif(file);
  if (gif.width % 2 != 0) throw std::runtime_error("the width of a POT file must be even");
  RawImage raw;
  raw.set_size(gif.width / 2, gif.height);
  raw.channels = 1;
  raw.bits = 16;
  for (int y = 0; y < gif.height; ++y)
    for (int x = 0; x < raw.width; ++x) {
      const std::uint8_t* row = &gif.indices[static_cast<std::size_t>(y) * gif.width];
      raw.samples.push_back(static_cast<float>(row[x] * 256 + row[x + raw.width]) / 65535.0f);
    }
  return raw;
}

RawImage decode(const std::filesystem::path& path, ImageType type) {
  switch (type) {
    case ImageType::png:
      return decode_png(read_file(path));
    case ImageType::ppm:
    case ImageType::pgm:
      return decode_netpbm(read_file(path));
    case ImageType::gif:
      return decode_gif(read_file(path));
    case ImageType::pot:
      return decode_pot(read_file(path));
    case ImageType::tga:
      return decode_tga(read_file(path));
    case ImageType::bmp:
      return decode_bmp(read_file(path));
    case ImageType::hdr:
      return decode_hdr(read_file(path));
    case ImageType::jpeg:
    case ImageType::tiff:
    case ImageType::exr:
      if (!std::filesystem::exists(path)) throw std::runtime_error("cannot open the file");
      return decode_with_module(path);
    case ImageType::iff:
      throw std::runtime_error("Unexpected EOF (POV-Ray cannot read IFF files either)");
    default:
      throw std::runtime_error("this image format is not supported here");
  }
}

// How file values become what patterns see.
struct Conversion {
  Curve file = Curve::identity();     // to linear light
  Curve working = Curve::identity();  // from linear light
  bool folded = false;                // both are powers: one exponent
  Curve power = Curve::identity();

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

void put_color(const float* in, int channels, const Conversion& convert, float* out) {
  const bool has_alpha = channels == 2 || channels == 4;
  const float alpha = has_alpha ? in[channels - 1] : 1.0f;
  for (int k = 0; k < 3; ++k) out[k] = convert(in[channels >= 3 ? k : 0]);
  out[3] = 1 - alpha;
}

// Straight alpha in a TIFF: libtiff, through which POV-Ray reads, multiplies 8-bit colours by it and rounds.
void multiply_alpha(RawImage& raw) {
  const std::size_t n = static_cast<std::size_t>(raw.channels);
  const float steps = raw.bits == 8 ? 255.0f : 65535.0f;
  for (std::size_t i = 0; i + n <= raw.samples.size(); i += n)
    for (std::size_t k = 0; k + 1 < n; ++k)
      raw.samples[i + k] = std::floor(raw.samples[i + k] * raw.samples[i + n - 1] * steps + 0.5f) / steps;
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
    for (std::size_t i = 0; i < raw.palette.size() / 4; ++i) {
      float rgbt[4];
      put_color(&raw.palette[4 * i], 4, convert, rgbt);
      image->palette.emplace_back(rgbt[0], rgbt[1], rgbt[2], 0.0f, rgbt[3]);
    }
    image->indices = raw.indices;
    // Files may use entries that their palette lacks.
    const std::uint8_t highest = *std::max_element(raw.indices.begin(), raw.indices.end());
    if (image->palette.size() <= highest) image->palette.resize(std::size_t{highest} + 1);
    return image;
  }
  const std::size_t count = static_cast<std::size_t>(raw.width) * raw.height,
                    n = static_cast<std::size_t>(raw.channels);
  image->pixels.resize(4 * count);
  if (type == ImageType::tiff && image->premultiplied && !raw.premultiplied && d.premultiplied < 0) multiply_alpha(raw);
  for (std::size_t i = 0; i < count; ++i) put_color(&raw.samples[i * n], raw.channels, convert, &image->pixels[4 * i]);
  if (raw.grey8)
    for (std::size_t i = 0; i < count; ++i)
      image->pixels[4 * i] = image->pixels[4 * i + 1] = image->pixels[4 * i + 2] = requantised(image->pixels[4 * i]);
  return image;
}

}  // namespace
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
