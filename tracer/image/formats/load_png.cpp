// PNG with everything that POV-Ray's rules look at: palette, tRNS, gAMA and sRGB chunks, original bit depth (spec 05
// section 12.1).
#include <png.h>

#include <csetjmp>
#include <cstring>
#include <new>
#include <stdexcept>

#include "tracer/image/formats/raw_image.h"

namespace verisim::image {
namespace {

// libpng calls back in C: the message waits here, control returns by longjmp.
struct PngSource {
  ByteReader& file;
  char message[160] = "";
};

void on_read_error(png_structp png, png_const_charp message) {
  auto* source = static_cast<PngSource*>(png_get_error_ptr(png));
  std::strncpy(source->message, message, sizeof source->message - 1);
  png_longjmp(png, 1);
}
void on_read_warning(png_structp, png_const_charp) {}
void on_read(png_structp png, png_bytep to, png_size_t count) {
  auto* source = static_cast<PngSource*>(png_get_io_ptr(png));
  if (count > source->file.left()) png_error(png, "unexpected end of file");
  bool whole = true;
  try {
    source->file.read(to, count);
  } catch (...) {
    whole = false;
  }
  if (!whole) png_error(png, "the file cannot be read");
}

struct PngReader {
  explicit PngReader(PngSource& source) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, on_read_error, on_read_warning);
    if (png) info = png_create_info_struct(png);
    if (!info) throw std::bad_alloc();
    png_set_read_fn(png, &source, on_read);
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  png_structp png = nullptr;
  png_infop info = nullptr;
};

struct Header {
  png_uint_32 width, height;
  int bits, type;
  bool has_srgb, has_gamma, has_transparency;
  double gamma;
  png_colorp palette;
  int palette_size;
  png_bytep palette_alpha;
  int palette_alpha_size;
};

// From here to the end of read_rows control may leave by longjmp: no objects with destructors.
bool read_header(PngReader& r, Header& h) {
  if (setjmp(png_jmpbuf(r.png))) return false;
  png_set_user_limits(r.png, 1u << 24, 1u << 24);
  png_read_info(r.png, r.info);
  png_get_IHDR(r.png, r.info, &h.width, &h.height, &h.bits, &h.type, nullptr, nullptr, nullptr);
  int intent;
  h.has_srgb = png_get_sRGB(r.png, r.info, &intent) != 0;
  h.has_gamma = png_get_gAMA(r.png, r.info, &h.gamma) != 0;
  h.has_transparency = png_get_valid(r.png, r.info, PNG_INFO_tRNS) != 0;
  if (h.type == PNG_COLOR_TYPE_PALETTE) {
    if (!png_get_PLTE(r.png, r.info, &h.palette, &h.palette_size)) png_error(r.png, "the palette is missing");
    if (h.has_transparency) png_get_tRNS(r.png, r.info, &h.palette_alpha, &h.palette_alpha_size, nullptr);
    png_set_packing(r.png);
  } else {
    png_set_expand(r.png);  // grey of less than 8 bits to 8, tRNS to alpha
    if (h.bits == 16) png_set_swap(r.png);
  }
  png_set_interlace_handling(r.png);
  png_read_update_info(r.png, r.info);
  return true;
}

bool read_rows(PngReader& r, png_bytepp rows) {
  if (setjmp(png_jmpbuf(r.png))) return false;
  png_read_image(r.png, rows);
  return true;
}

}  // namespace

RawImage decode_png(ByteReader& in) {
  PngSource source{in};
  PngReader reader(source);
  Header h{};
  if (!read_header(reader, h)) throw std::runtime_error(source.message);
  RawImage raw;
  raw.set_size(h.width, h.height);
  raw.channels = png_get_channels(reader.png, reader.info);  // of a palette image: 1, an index
  raw.bits = h.bits == 16 ? 16 : 8;
  raw.white = h.bits == 16 ? 65535 : 255;
  raw.grey8 = h.type == PNG_COLOR_TYPE_GRAY && h.bits <= 8 && !h.has_transparency;
  if (h.has_srgb) {
    raw.curve = RawImage::Curve::srgb;
  } else if (h.has_gamma && h.gamma > 0) {
    raw.curve = RawImage::Curve::power;
    raw.gamma = 1 / h.gamma;
  }

  raw.allocate(h.bits == 16 ? SampleType::word : SampleType::byte);
  const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
  if (row_bytes * h.height != raw.samples.memory()) throw std::runtime_error("unknown kind of PNG file");
  std::vector<png_bytep> rows(h.height);
  for (png_uint_32 y = 0; y < h.height; ++y) rows[y] = raw.samples.as<std::uint8_t>() + y * row_bytes;
  if (!read_rows(reader, rows.data())) throw std::runtime_error(source.message);

  if (h.type == PNG_COLOR_TYPE_PALETTE) {
    for (int i = 0; i < h.palette_size; ++i) {
      const png_color c = h.palette[i];
      const float alpha =
          h.has_transparency && i < h.palette_alpha_size ? static_cast<float>(h.palette_alpha[i]) / 255.0f : 1.0f;
      raw.palette.insert(raw.palette.end(), {static_cast<float>(c.red) / 255.0f, static_cast<float>(c.green) / 255.0f,
                                             static_cast<float>(c.blue) / 255.0f, alpha});
    }
    raw.channels = h.has_transparency ? 4 : 3;
  }
  return raw;
}

}  // namespace verisim::image
