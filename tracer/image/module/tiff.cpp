// The plug-in for TIFF files: 8 and 16 bits or single precision, grey or RGB with or without alpha, in strips or tiles.
#include <tiffio.h>

#include <cstdarg>
#include <cstdio>
#include <memory>
#include <vector>

#include "tracer/image/module/seam.h"

namespace verisim::image {
namespace {

struct Messages {
  char first[256] = "";
};

int on_error(TIFF*, void* user, const char* module, const char* format, va_list arguments) {
  auto* messages = static_cast<Messages*>(user);
  if (messages->first[0]) return 1;
  const int n = module ? std::snprintf(messages->first, sizeof messages->first, "%s: ", module) : 0;
  if (n >= 0 && n < static_cast<int>(sizeof messages->first))
    std::vsnprintf(messages->first + n, sizeof messages->first - static_cast<std::size_t>(n), format, arguments);
  return 1;
}
int on_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

struct Close {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using File = std::unique_ptr<TIFF, Close>;

File open(const char* path, Messages& messages) {
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 TIFFOpenOptionsFree);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, &messages);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), on_warning, nullptr);
  return File(TIFFOpenExt(path, "r", options.get()));
}

template <class T>
T field(const File& file, ttag_t tag, T otherwise) {
  T value = otherwise;
  return TIFFGetFieldDefaulted(file.get(), tag, &value) ? value : otherwise;
}

// Fills in how the file stores its samples; false: this plug-in leaves it to OpenImageIO's.
bool describe(const File& file, VerisimImage& image) {
  const auto samples = field<std::uint16_t>(file, TIFFTAG_SAMPLESPERPIXEL, 1),
             bits = field<std::uint16_t>(file, TIFFTAG_BITSPERSAMPLE, 1),
             format = field<std::uint16_t>(file, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT),
             photometric = field<std::uint16_t>(file, TIFFTAG_PHOTOMETRIC, 0xffff),
             compression = field<std::uint16_t>(file, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  const bool integer = format == SAMPLEFORMAT_UINT && (bits == 8 || bits == 16);
  if (!integer && !(format == SAMPLEFORMAT_IEEEFP && bits == 32)) return false;
  if (field<std::uint16_t>(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) != PLANARCONFIG_CONTIG) return false;
  if (field<std::uint32_t>(file, TIFFTAG_IMAGEDEPTH, 1) != 1) return false;
  if (compression == COMPRESSION_JPEG || compression == COMPRESSION_OJPEG || !TIFFIsCODECConfigured(compression))
    return false;
  const int colors = photometric == PHOTOMETRIC_MINISBLACK ? 1 : photometric == PHOTOMETRIC_RGB ? 3 : 0;
  if (colors == 0 || (samples != colors && samples != colors + 1)) return false;
  std::uint16_t extra = 0;
  const std::uint16_t* kinds = nullptr;
  TIFFGetFieldDefaulted(file.get(), TIFFTAG_EXTRASAMPLES, &extra, &kinds);
  if (extra != samples - colors) return false;
  if (extra == 1) {
    if (kinds[0] != EXTRASAMPLE_ASSOCALPHA && kinds[0] != EXTRASAMPLE_UNASSALPHA) return false;
    image.premultiplied = kinds[0] == EXTRASAMPLE_ASSOCALPHA;
  }
  image.channels = samples;
  image.sample = bits == 8 ? kVerisimUint8 : bits == 16 ? kVerisimUint16 : kVerisimFloat;
  return true;
}

// Strips are rows of the picture: they are decoded in their place.
bool read_strips(const File& file, std::uint8_t* to, std::size_t row_bytes, std::uint32_t height) {
  const auto rows = std::min(field<std::uint32_t>(file, TIFFTAG_ROWSPERSTRIP, height), height);
  if (rows == 0 || TIFFScanlineSize64(file.get()) != row_bytes) return false;
  std::uint32_t strip = 0;
  for (std::uint32_t y = 0; y < height; y += rows, ++strip) {
    const auto bytes = static_cast<tmsize_t>(std::min(rows, height - y) * row_bytes);
    if (TIFFReadEncodedStrip(file.get(), strip, to + y * row_bytes, bytes) != bytes) return false;
  }
  return true;
}

bool read_tiles(const File& file, std::uint8_t* to, std::size_t pixel_bytes, std::uint32_t width, std::uint32_t height,
                std::uint64_t max_pixels) {
  const auto w = field<std::uint32_t>(file, TIFFTAG_TILEWIDTH, 0),
             h = field<std::uint32_t>(file, TIFFTAG_TILELENGTH, 0);
  if (w == 0 || h == 0 || std::uint64_t{w} * h > max_pixels) return false;
  std::vector<std::uint8_t> tile(std::size_t{w} * h * pixel_bytes);
  if (TIFFTileSize64(file.get()) != tile.size()) return false;
  for (std::uint32_t y = 0; y < height; y += h)
    for (std::uint32_t x = 0; x < width; x += w) {
      if (TIFFReadTile(file.get(), tile.data(), x, y, 0, 0) < 0) return false;
      const std::size_t row = std::min(w, width - x) * pixel_bytes;
      for (std::uint32_t j = 0; j < std::min(h, height - y); ++j)
        std::memcpy(to + (std::size_t{y + j} * width + x) * pixel_bytes, tile.data() + std::size_t{j} * w * pixel_bytes,
                    row);
    }
  return true;
}

int read_image(const char* path, std::uint64_t max_pixels, VerisimImage* image, char* error, std::size_t error_size) {
  Messages messages;
  const File file = open(path, messages);
  if (!file) return fail(error, error_size, messages.first[0] ? messages.first : "this is not a TIFF file");
  const auto width = field<std::uint32_t>(file, TIFFTAG_IMAGEWIDTH, 0),
             height = field<std::uint32_t>(file, TIFFTAG_IMAGELENGTH, 0);
  if (width == 0 || height == 0) return fail(error, error_size, "the image has no pixels");
  if (std::uint64_t{width} * height > max_pixels || width > 0x7fffffff || height > 0x7fffffff)
    return fail(error, error_size, "the image is too large");
  if (!describe(file, *image)) return kVerisimLeft;
  image->width = static_cast<std::int32_t>(width);
  image->height = static_cast<std::int32_t>(height);
  const std::size_t sample_bytes = image->sample == kVerisimUint8    ? 1
                                   : image->sample == kVerisimUint16 ? 2
                                                                     : 4,
                    pixel_bytes = sample_bytes * static_cast<std::size_t>(image->channels);
  allocate_pixels(*image, sample_bytes);
  auto* to = static_cast<std::uint8_t*>(image->pixels);
  const bool whole = TIFFIsTiled(file.get()) ? read_tiles(file, to, pixel_bytes, width, height, max_pixels)
                                             : read_strips(file, to, pixel_bytes * width, height);
  if (whole) return kVerisimDone;
  free_pixels(*image);
  return kVerisimLeft;  // damaged: OpenImageIO knows when to go on, as POV-Ray does
}

}  // namespace
}  // namespace verisim::image

VERISIM_EXPORT_READER(verisim::image::read_image)
