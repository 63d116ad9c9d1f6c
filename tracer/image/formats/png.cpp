#include "tracer/image/formats/png.h"

#include <libdeflate.h>
#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <csetjmp>
#include <ctime>
#include <memory>
#include <new>
#include <stdexcept>

#include "tracer/image/formats/raw_image.h"

namespace verisim::image {
namespace {

// libpng reports through a C callback; the message waits here until control is back in C++.
struct Failure {
  std::string message;
};

void on_error(png_structp png, png_const_charp message) {
  static_cast<Failure*>(png_get_error_ptr(png))->message = message;
  png_longjmp(png, 1);
}
void on_warning(png_structp, png_const_charp) {}

struct Writer {
  Failure failure;
  png_structp png = nullptr;
  png_infop info = nullptr;
  Writer() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure, on_error, on_warning);
    if (png) info = png_create_info_struct(png);
    if (!info) throw std::bad_alloc();
  }
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

struct Reader {
  Failure failure;
  png_structp png = nullptr;
  png_infop info = nullptr;
  Reader() {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure, on_error, on_warning);
    if (png) info = png_create_info_struct(png);
    if (!info) throw std::bad_alloc();
  }
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

int color_type(int channels) {
  switch (channels) {
    case 1:
      return PNG_COLOR_TYPE_GRAY;
    case 2:
      return PNG_COLOR_TYPE_GRAY_ALPHA;
    case 3:
      return PNG_COLOR_TYPE_RGB;
    default:
      return PNG_COLOR_TYPE_RGB_ALPHA;
  }
}

// Writing time counts more than size here: one filter for all rows, the differences between neighbours, and the fastest
// deflate there is.
class RowPacker {
 public:
  explicit RowPacker(const Quantised& picture)
      : samples_(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.channels)),
        wide_(picture.bits == 16),
        pixel_(static_cast<std::size_t>(picture.channels) * (wide_ ? 2 : 1)),
        plain_(samples_ * (wide_ ? 2 : 1)),
        filtered_(plain_.size() + 1) {
    filtered_[0] = PNG_FILTER_VALUE_SUB;
  }
  std::size_t row_size() const { return filtered_.size(); }  // bytes
  // The row as the file has it, before compression.
  const std::vector<png_byte>& pack(const std::uint16_t* in) {
    png_byte* const row = plain_.data();
    png_byte* const out = filtered_.data() + 1;
    const std::size_t samples = samples_, pixel = pixel_,
                      size = plain_.size();  // bytes that are written might be the members, for all the compiler knows
    if (wide_) {
      for (std::size_t i = 0; i < samples; ++i)
        row[2 * i] = static_cast<png_byte>(in[i] >> 8), row[2 * i + 1] = static_cast<png_byte>(in[i] & 255);
    } else {
      for (std::size_t i = 0; i < samples; ++i) row[i] = static_cast<png_byte>(in[i]);
    }
    std::copy_n(row, pixel, out);
    for (std::size_t i = pixel; i < size; ++i) out[i] = static_cast<png_byte>(row[i] - row[i - pixel]);
    return filtered_;
  }

 private:
  std::size_t samples_;
  bool wide_;
  std::size_t pixel_;  // bytes
  std::vector<png_byte> plain_, filtered_;
};

void write_image_data(png_structp png, const png_byte* bytes, std::size_t size) {
  png_write_chunk(png, reinterpret_cast<png_const_bytep>("IDAT"), bytes, size);
}

// Compresses a picture as a whole, in one IDAT chunk: libdeflate takes half of zlib's time for files of the same size.
// (ISA-L, faster still, was tried: its output hangs on where memory lies and on the processor, while the same picture
// shall be the same file.)
class WholeDeflater {
 public:
  explicit WholeDeflater(std::size_t size)
      : compressor_(libdeflate_alloc_compressor(kLevel), libdeflate_free_compressor), size_(size) {
    if (!compressor_) throw std::bad_alloc();
    bytes_ = std::make_unique_for_overwrite<png_byte[]>(size);
    room_ = libdeflate_zlib_compress_bound(compressor_.get(), size);
    out_ = std::make_unique_for_overwrite<png_byte[]>(room_);
  }
  // May leave by libpng's longjmp.
  void put(png_structp png, const std::vector<png_byte>& row, bool last) {
    std::copy(row.begin(), row.end(), bytes_.get() + filled_);
    filled_ += row.size();
    if (!last) return;
    const std::size_t n = libdeflate_zlib_compress(compressor_.get(), bytes_.get(), size_, out_.get(), room_);
    if (n == 0) png_error(png, "the picture cannot be compressed");
    write_image_data(png, out_.get(), n);
  }

 private:
  static constexpr int kLevel = 1;  // the others take 1.3 to 1.5 of its time for files 1 % smaller
  std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor_;
  std::size_t size_, filled_ = 0, room_;
  std::unique_ptr<png_byte[]> bytes_, out_;
};

// Compresses a picture piece by piece, so that a large one is never in memory as a whole.
class StreamDeflater {
 public:
  StreamDeflater() {
    // Of 250 scenes' pictures: 0.73 of the time of level 3, files 3 % larger; level 1: 0.68 and 5.5 %.
    constexpr int kLevel = 2;
    if (deflateInit(&stream_, kLevel) != Z_OK) throw std::bad_alloc();
    stream_.next_out = out_.data();
    stream_.avail_out = kChunk;
  }
  ~StreamDeflater() { deflateEnd(&stream_); }
  StreamDeflater(const StreamDeflater&) = delete;
  StreamDeflater& operator=(const StreamDeflater&) = delete;
  // May leave by libpng's longjmp.
  void put(png_structp png, const std::vector<png_byte>& bytes, bool last) {
    stream_.next_in = const_cast<png_byte*>(bytes.data());
    stream_.avail_in = static_cast<uInt>(bytes.size());
    for (;;) {
      const int result = deflate(&stream_, last ? Z_FINISH : Z_NO_FLUSH);
      if (result == Z_STREAM_ERROR) png_error(png, "the picture cannot be compressed");
      const bool done = last ? result == Z_STREAM_END : stream_.avail_in == 0;
      if (stream_.avail_out == 0 || (done && last)) write_chunk(png);
      if (done) return;
    }
  }

 private:
  static constexpr uInt kChunk = 1 << 16;
  void write_chunk(png_structp png) {
    if (stream_.avail_out < kChunk) write_image_data(png, out_.data(), kChunk - stream_.avail_out);
    stream_.next_out = out_.data();
    stream_.avail_out = kChunk;
  }
  z_stream stream_{};
  std::vector<png_byte> out_ = std::vector<png_byte>(kChunk);
};

using RowSource = std::function<void(int y, std::uint16_t* row)>;

// Everything between here and the caller may be left by longjmp: no objects with destructors.
template <class Deflater>
bool write_all(Writer& w, std::FILE* file, const Quantised& picture, const OutputOptions& options,
               const RowSource& rows, std::uint16_t* samples, RowPacker& packer, Deflater& deflater, png_text* texts,
               int text_count) {
  if (setjmp(png_jmpbuf(w.png))) return false;
  png_init_io(w.png, file);
  png_set_IHDR(w.png, w.info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height),
               picture.bits, color_type(picture.channels), PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  // Without gamma handling the tags name what the values will be shown as, sRGB (spec 02 section 4.1).
  if (options.file_srgb || options.working == scene::Gamma::none) {
    png_set_sRGB_gAMA_and_cHRM(w.png, w.info, PNG_sRGB_INTENT_PERCEPTUAL);
  } else {
    png_set_gAMA(w.png, w.info, 1.0 / options.file_gamma);
  }
  png_color_8 significant{};
  const auto bits = static_cast<png_byte>(options.greyscale ? picture.bits : std::min(options.bits, picture.bits));
  significant.red = significant.green = significant.blue = significant.gray = significant.alpha = bits;
  png_set_sBIT(w.png, w.info, &significant);
  png_set_oFFs(w.png, w.info, 0, 0, PNG_OFFSET_PIXEL);
  if (options.time) {
    png_time time;
    const std::time_t seconds = *options.time;
    std::tm utc{};
    gmtime_r(&seconds, &utc);  // png_convert_from_time_t uses gmtime's static buffer
    png_convert_from_struct_tm(&time, &utc);
    png_set_tIME(w.png, w.info, &time);
  }
  if (text_count) png_set_text(w.png, w.info, texts, text_count);
  png_write_info(w.png, w.info);
  for (int y = 0; y < picture.height; ++y) {
    rows(y, samples);
    deflater.put(w.png, packer.pack(samples), y + 1 == picture.height);
  }
  png_write_chunk(w.png, reinterpret_cast<png_const_bytep>("IEND"), nullptr, 0);  // png_write_end would miss the rows
  return true;
}

bool read_header(Reader& r, std::FILE* file) {
  if (setjmp(png_jmpbuf(r.png))) return false;
  png_set_user_limits(r.png, kMaxSide, kMaxSide);
  png_init_io(r.png, file);
  png_read_info(r.png, r.info);
  png_set_expand(r.png);  // palettes to RGB, less than 8 bits to 8, tRNS to alpha
  png_set_interlace_handling(r.png);
  png_read_update_info(r.png, r.info);
  return true;
}

bool read_row(Reader& r, png_byte* row, bool last) {
  if (setjmp(png_jmpbuf(r.png))) return false;
  png_read_row(r.png, row, nullptr);
  if (last) png_read_end(r.png, nullptr);
  return true;
}

bool read_rows(Reader& r, png_byte** rows) {
  if (setjmp(png_jmpbuf(r.png))) return false;
  png_read_image(r.png, rows);
  png_read_end(r.png, nullptr);
  return true;
}

}  // namespace

void write_png(std::FILE* file, const Quantised& picture, const OutputOptions& options) {
  const std::size_t n = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.channels);
  write_png(file, picture, options, [&](int y, std::uint16_t* row) {
    std::copy_n(picture.samples.data() + n * static_cast<std::size_t>(y), n, row);
  });
}

void write_png(std::FILE* file, const Quantised& picture, const OutputOptions& options, const RowSource& rows) {
  std::map<std::string, std::string> metadata = options.metadata;
  metadata.try_emplace("Software", "verisim");
  std::vector<png_text> texts;
  for (auto& [key, value] : metadata) {
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(key.c_str());
    text.text = const_cast<char*>(value.c_str());
    texts.push_back(text);
  }
  std::vector<std::uint16_t> samples(static_cast<std::size_t>(picture.width) *
                                     static_cast<std::size_t>(picture.channels));
  RowPacker packer(picture);
  Writer w;
  const auto write = [&](auto deflater) {
    return write_all(w, file, picture, options, rows, samples.data(), packer, *deflater, texts.data(),
                     static_cast<int>(texts.size()));
  };
  constexpr std::size_t kLarge = 1 << 23;  // more than 1920 by 1080 of 8 bits
  const std::size_t size = packer.row_size() * static_cast<std::size_t>(picture.height);
  if (!(size > kLarge ? write(std::make_unique<StreamDeflater>()) : write(std::make_unique<WholeDeflater>(size))))
    throw std::runtime_error(w.failure.message);
}

Quantised read_png(std::FILE* file) {
  Reader r;
  if (!read_header(r, file)) throw std::runtime_error(r.failure.message);
  Quantised picture;
  picture.width = static_cast<int>(png_get_image_width(r.png, r.info));
  picture.height = static_cast<int>(png_get_image_height(r.png, r.info));
  picture.channels = png_get_channels(r.png, r.info);
  picture.bits = png_get_bit_depth(r.png, r.info);
  const std::size_t count = static_cast<std::size_t>(picture.width) * picture.height * picture.channels;
  if (count > kMaxSamples) throw std::runtime_error("the picture is too large");
  const std::size_t row_bytes = png_get_rowbytes(r.png, r.info);
  std::vector<png_byte> bytes(row_bytes * picture.height);
  std::vector<png_byte*> rows(static_cast<std::size_t>(picture.height));
  for (int y = 0; y < picture.height; ++y) rows[y] = bytes.data() + row_bytes * y;
  if (!read_rows(r, rows.data())) throw std::runtime_error(r.failure.message);
  picture.samples.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    picture.samples[i] =
        picture.bits == 16 ? static_cast<std::uint16_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]) : bytes[i];
  return picture;
}

struct PngRows::State {
  Reader reader;
  std::vector<png_byte> bytes;
  int row = 0;
};

PngRows::PngRows(std::FILE* file) : state_(std::make_unique<State>()) {
  Reader& r = state_->reader;
  if (!read_header(r, file)) throw std::runtime_error(r.failure.message);
  width = static_cast<int>(png_get_image_width(r.png, r.info));
  height = static_cast<int>(png_get_image_height(r.png, r.info));
  channels = png_get_channels(r.png, r.info);
  bits = png_get_bit_depth(r.png, r.info);
  interlaced = png_get_interlace_type(r.png, r.info) != PNG_INTERLACE_NONE;
  state_->bytes.resize(png_get_rowbytes(r.png, r.info));
}

PngRows::~PngRows() = default;

void PngRows::next(std::uint16_t* row) {
  std::vector<png_byte>& bytes = state_->bytes;
  if (!read_row(state_->reader, bytes.data(), ++state_->row == height))
    throw std::runtime_error(state_->reader.failure.message);
  const std::size_t n = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < n; ++i)
    row[i] = bits == 16 ? static_cast<std::uint16_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]) : bytes[i];
}

}  // namespace verisim::image
