// JPEG by libjpeg-turbo, row by row into the picture's own memory.
#include <cstdio>
// jpeglib.h needs the header above.
#include <jpeglib.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <stdexcept>

#include "tracer/image/formats/raw_image.h"

namespace verisim::image {
namespace {

// libjpeg calls back in C: the message waits here, control returns by longjmp.
struct Errors {
  jpeg_error_mgr base;
  std::jmp_buf jump;
  char message[JMSG_LENGTH_MAX] = "";
};

[[noreturn]] void on_error(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<Errors*>(jpeg->err);
  jpeg->err->format_message(jpeg, errors->message);
  std::longjmp(errors->jump, 1);
}
void on_message(j_common_ptr) {}
void on_warning(j_common_ptr, int) {}  // damaged data are drawn as far as they go, as POV-Ray draws them

struct JpegSource {
  jpeg_source_mgr base;
  ByteReader* in;
};

void start(j_decompress_ptr) {}

// As in POV-Ray a file that ends before its end mark is an error; libjpeg alone would fill the rest with grey.
boolean fill(j_decompress_ptr jpeg) {
  auto* source = reinterpret_cast<JpegSource*>(jpeg->src);
  auto* errors = reinterpret_cast<Errors*>(jpeg->err);
  source->base.bytes_in_buffer = 0;
  try {
    const std::size_t n = std::min<std::size_t>(source->in->left(), 1 << 16);
    if (n > 0) {
      source->base.next_input_byte = source->in->take(n).data();
      source->base.bytes_in_buffer = n;
    }
  } catch (...) {
    // No exception may pass the library; what cannot be read is missing.
  }
  if (source->base.bytes_in_buffer > 0) return TRUE;
  std::strncpy(errors->message, "the JPEG file is cut off: its end is missing", sizeof errors->message - 1);
  std::longjmp(errors->jump, 1);
}

void skip(j_decompress_ptr jpeg, long count) {
  jpeg_source_mgr& base = *jpeg->src;
  for (auto left = static_cast<std::size_t>(std::max(count, 0L)); left > 0;) {
    if (base.bytes_in_buffer == 0) fill(jpeg);
    const std::size_t n = std::min(left, base.bytes_in_buffer);
    base.next_input_byte += n;
    base.bytes_in_buffer -= n;
    left -= n;
  }
}

struct JpegReader {
  explicit JpegReader(ByteReader& in) {
    jpeg.err = jpeg_std_error(&errors.base);
    errors.base.error_exit = on_error;
    errors.base.output_message = on_message;
    errors.base.emit_message = on_warning;
    source.base = {nullptr, 0, start, fill, skip, jpeg_resync_to_restart, start};
    source.in = &in;
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg); }
  Errors errors;
  JpegSource source{};
  jpeg_decompress_struct jpeg{};
};

// Files hold what is left of white by each ink, as Adobe writes them.
void rgb_from_cmyk(const std::uint8_t* cmyk, std::size_t pixels, std::uint8_t* rgb) {
  for (; pixels > 0; --pixels, cmyk += 4, rgb += 3)
    for (int k = 0; k < 3; ++k) rgb[k] = static_cast<std::uint8_t>((cmyk[k] * cmyk[3] + 127) / 255);
}

// In these two control may leave by longjmp: no objects with destructors.
bool read_header(JpegReader& r) {
  if (setjmp(r.errors.jump)) return false;
  jpeg_create_decompress(&r.jpeg);
  r.jpeg.src = &r.source.base;
  jpeg_read_header(&r.jpeg, TRUE);
  return true;
}

// `inks`: a row of CMYK, or null.
bool read_rows(JpegReader& r, std::uint8_t* to, std::size_t row_samples, std::uint8_t* inks) {
  if (setjmp(r.errors.jump)) return false;
  jpeg_start_decompress(&r.jpeg);
  while (r.jpeg.output_scanline < r.jpeg.output_height) {
    std::uint8_t* const row = to + r.jpeg.output_scanline * row_samples;
    JSAMPROW wanted = inks ? inks : row;
    jpeg_read_scanlines(&r.jpeg, &wanted, 1);
    if (inks) rgb_from_cmyk(inks, r.jpeg.output_width, row);
  }
  jpeg_finish_decompress(&r.jpeg);
  return true;
}

}  // namespace

RawImage decode_jpeg(ByteReader& in) {
  JpegReader reader(in);
  if (!read_header(reader)) throw std::runtime_error(reader.errors.message);
  RawImage raw;
  raw.set_size(reader.jpeg.image_width, reader.jpeg.image_height);
  const int components = reader.jpeg.num_components;
  if (components != 1 && components != 3 && components != 4)
    throw std::runtime_error("this number of components in a JPEG file is not supported");
  const bool cmyk = components == 4;
  if (cmyk) reader.jpeg.out_color_space = JCS_CMYK;
  raw.channels = components == 1 ? 1 : 3;
  raw.allocate(SampleType::byte);
  std::vector<std::uint8_t> inks(cmyk ? static_cast<std::size_t>(raw.width) * 4 : 0);
  const std::size_t row = static_cast<std::size_t>(raw.width) * static_cast<std::size_t>(raw.channels);
  if (!read_rows(reader, raw.samples.as<std::uint8_t>(), row, cmyk ? inks.data() : nullptr))
    throw std::runtime_error(reader.errors.message);
  return raw;
}

}  // namespace verisim::image
