#include "tracer/image/formats/module_files.h"

#include <ctime>
#include <span>
#include <stdexcept>

#include "tracer/image/gamma.h"
#include "tracer/image/module/module.h"
#include "tracer/image/formats/raw_image.h"

namespace verisim::image {
namespace {

void save(const std::filesystem::path& path, const VerisimImage& image, const OutputOptions& options,
          const char* compression, int quality) {
  std::map<std::string, std::string> described = options.metadata;
  // What the extension area of TGA and the headers of the others call it (OpenImageIO's names).
  if (const auto title = described.find("Title"); title != described.end()) described["DocumentName"] = title->second;
  if (const auto comment = described.find("Comment"); comment != described.end())
    described["ImageDescription"] = comment->second;
  if (options.time || options.format == Format::tiff || options.format == Format::exr)
    described["DateTime"] = date_text(options);
  std::vector<const char*> metadata;
  for (const auto& [key, value] : described) metadata.push_back(key.c_str()), metadata.push_back(value.c_str());
  const VerisimWriteOptions how{&image,          compression, quality, 0, static_cast<std::int32_t>(described.size()),
                                metadata.data(), nullptr,     nullptr};
  char error[512] = {};
  if (image_module().write(path.c_str(), &how, error, sizeof error) != 0) throw std::runtime_error(error);
}

// EXR and HDR hold linear light; EXR keeps colours multiplied by alpha.
void save_float(const ColorRows& rows, const std::filesystem::path& path, const OutputOptions& options) {
  const OutputCurve to_linear(options.working, options.working_gamma, Curve::identity());
  const bool exr = options.format == Format::exr, alpha = exr && options.alpha;
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(rows.width) * static_cast<std::size_t>(rows.height) * 4);
  for (int y = 0; y < rows.height; ++y) {
    for (const render::PixelColor& c : std::span(rows.row(y), static_cast<std::size_t>(rows.width))) {
      if (options.greyscale) {
        values.push_back(to_linear.encode(c.grey()));
      } else {
        values.insert(values.end(), {to_linear.encode(c.r), to_linear.encode(c.g), to_linear.encode(c.b)});
      }
      if (alpha) values.push_back(1.0f - c.t);
    }
  }
  const VerisimImage image{rows.width,
                           rows.height,
                           (options.greyscale ? 1 : 3) + (alpha ? 1 : 0),
                           exr ? kVerisimHalf : kVerisimFloat,
                           values.data(),
                           1};
  save(path, image, options, exr ? "zip" : nullptr, 0);
}

void save_integers(const Quantised& q, const std::filesystem::path& path, const OutputOptions& options) {
  std::vector<std::uint8_t> bytes(q.samples.begin(), q.samples.end());
  const VerisimImage image{q.width, q.height, q.channels, kVerisimUint8, bytes.data(), 0};
  const char* compression = options.format == Format::tga       ? "none"
                            : options.format == Format::tga_rle ? "rle"
                                                                : nullptr;
  const int quality = options.format != Format::jpeg ? 0
                      : options.compression < 2      ? 85
                                                     : std::min(options.compression, 100);
  save(path, image, options, compression, quality);
}

}  // namespace

std::string date_text(const OutputOptions& options) {
  if (!options.time) return "    :  :     :  :  ";
  const std::time_t seconds = *options.time;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32] = {};
  std::strftime(text, sizeof text, "%Y:%m:%d %H:%M:%S", &utc);
  return text;
}

void write_through_module(const ColorRows& rows, const std::filesystem::path& path, const OutputOptions& options) {
  if (options.format == Format::exr || options.format == Format::hdr) {
    save_float(rows, path, options);
  } else {
    save_integers(quantise(rows, options), path, options);
  }
}

Picture read_through_module(const std::filesystem::path& path) {
  VerisimImage image{};
  char error[512] = {};
  const Module& module = image_module();
  if (module.read(path.c_str(), kMaxStoredPixels, &image, error, sizeof error) != 0) throw std::runtime_error(error);
  Picture picture{image.width,
                  image.height,
                  image.channels,
                  image.sample == kVerisimFloat || image.sample == kVerisimHalf,
                  image.sample == kVerisimUint8 ? 8 : 16,
                  {}};
  const std::size_t count = static_cast<std::size_t>(image.width) * image.height * image.channels;
  try {
    picture.samples.resize(count);
  } catch (...) {
    module.free(&image);
    throw;
  }
  for (std::size_t i = 0; i < count; ++i) {
    switch (image.sample) {
      case kVerisimUint8:
        picture.samples[i] = static_cast<float>(static_cast<const std::uint8_t*>(image.pixels)[i]) / 255.0f;
        break;
      case kVerisimUint16:
        picture.samples[i] = static_cast<float>(static_cast<const std::uint16_t*>(image.pixels)[i]) / 65535.0f;
        break;
      default:
        picture.samples[i] = static_cast<const float*>(image.pixels)[i];
        break;
    }
  }
  module.free(&image);
  return picture;
}

}  // namespace verisim::image
