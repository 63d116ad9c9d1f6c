#include "tracer/image/output.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "tracer/image/formats/hdr.h"
#include "tracer/image/formats/jpeg_end.h"
#include "tracer/image/formats/module_files.h"
#include "tracer/image/formats/netpbm.h"
#include "tracer/image/picture_rows.h"
#include "tracer/image/formats/png.h"
#include "tracer/base/output_file.h"

namespace verisim::image {

const char* extension_of(Format format) {
  switch (format) {
    case Format::png:
      return ".png";
    case Format::tga:
    case Format::tga_rle:
      return ".tga";
    case Format::ppm:
      return ".ppm";
    case Format::bmp:
      return ".bmp";
    case Format::jpeg:
      return ".jpg";
    case Format::exr:
      return ".exr";
    case Format::hdr:
      return ".hdr";
    case Format::tiff:
      return ".tif";
  }
  return "";
}

namespace {

struct FileCloser {
  void operator()(std::FILE* f) const { std::fclose(f); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& action, const std::string& reason) {
  throw std::runtime_error("cannot " + action + " '" + path.string() + "': " + reason);
}

// Runs `body` on a new file that takes the place of `path` when all went well: readers never see half a picture.
template <class Body>
void write_atomically(const std::filesystem::path& path, Body body) {
  if (path == "-") {
    body(stdout);
    if (std::fflush(stdout) != 0) fail("standard output", "write", std::strerror(errno));
    return;
  }
  OutputFile file(path);
  try {
    body(file.get());
  } catch (const std::exception& error) {
    fail(path, "write", error.what());
  }
  file.publish();
}

// The module writes by name; standard output receives a copy of what it wrote.
void write_module_file(const ColorRows& rows, const std::filesystem::path& path, const OutputOptions& options) {
  write_by_name(path, extension_of(options.format),
                [&](const std::filesystem::path& temporary) { write_through_module(rows, temporary, options); });
}

float sample_scale(int bits) { return 1.0f / static_cast<float>((1 << bits) - 1); }

Picture normalised(const Quantised& in) {
  Picture out{in.width, in.height, in.channels, false, in.bits, {}};
  const float scale = sample_scale(in.bits);
  out.samples.resize(in.samples.size());
  for (std::size_t i = 0; i < in.samples.size(); ++i) out.samples[i] = static_cast<float>(in.samples[i]) * scale;
  return out;
}

// What cannot hold a picture is told in these words, before a reader of some format says that it is none of its files.
void require_picture_file(const std::filesystem::path& path) {
  std::error_code failed;
  const auto type = std::filesystem::status(path, failed).type();
  if (type == std::filesystem::file_type::directory) fail(path, "read", "it is a folder");
  if (type == std::filesystem::file_type::not_found || failed) return;  // opening it says why
  if (type != std::filesystem::file_type::regular)
    fail(path, "read", "it is a pipe or a device; pictures are read from files");
  if (std::filesystem::file_size(path, failed) == 0) fail(path, "read", "the file is empty");
}

bool is_png(std::FILE* file) {
  unsigned char magic[8] = {};
  const std::size_t got = std::fread(magic, 1, sizeof magic, file);
  std::rewind(file);
  return got == 8 && std::memcmp(magic, "\x89PNG\r\n\x1a\n", 8) == 0;
}

class PngFileRows : public PictureRows {
 public:
  PngFileRows(std::filesystem::path path, File file)
      : path_(std::move(path)), file_(std::move(file)), png_(file_.get()) {
    width = png_.width, height = png_.height, channels = png_.channels, bits = png_.bits;
    row_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(channels));
  }
  bool interlaced() const { return png_.interlaced; }
  void next(float* row) override {
    try {
      png_.next(row_.data());
    } catch (const std::runtime_error& error) {
      fail(path_, "read", error.what());
    }
    const float scale = sample_scale(bits);
    for (std::size_t i = 0; i < row_.size(); ++i) row[i] = static_cast<float>(row_[i]) * scale;
  }

 private:
  std::filesystem::path path_;
  File file_;
  PngRows png_;
  std::vector<std::uint16_t> row_;
};

class WholePictureRows : public PictureRows {
 public:
  explicit WholePictureRows(Picture picture) : picture_(std::move(picture)) {
    width = picture_.width, height = picture_.height, channels = picture_.channels, bits = picture_.bits,
    is_float = picture_.is_float;
  }
  void next(float* row) override {
    const std::size_t n = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
    std::copy_n(picture_.samples.data() + n * static_cast<std::size_t>(row_++), n, row);
  }
  const Picture* whole() const override { return &picture_; }

 private:
  Picture picture_;
  int row_ = 0;
};

}  // namespace

void write(const render::Framebuffer& framebuffer, const std::filesystem::path& path, const OutputOptions& options) {
  write(rows_of(framebuffer), path, options);
}

void write(const ColorRows& rows, const std::filesystem::path& path, const OutputOptions& options) {
  if (options.format == Format::hdr)
    return write_atomically(path, [&](std::FILE* file) { write_hdr(file, rows, options); });
  if (options.format != Format::png && options.format != Format::ppm) return write_module_file(rows, path, options);
  if (options.format == Format::ppm)
    return write_atomically(
        path, [&, picture = quantise(rows, options)](std::FILE* file) { write_ppm(file, picture, options); });
  Quantiser quantised(rows, options);
  write_atomically(path, [&](std::FILE* file) {
    write_png(file, quantised.shape(), options, [&](int y, std::uint16_t* row) { quantised.row(y, row); });
  });
}

Picture read_picture(const std::filesystem::path& path) {
  require_picture_file(path);
  File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail(path, "open", std::strerror(errno));
  unsigned char magic[8] = {};
  const std::size_t got = std::fread(magic, 1, sizeof magic, file.get());
  std::rewind(file.get());
  try {
    if (got == 8 && std::memcmp(magic, "\x89PNG\r\n\x1a\n", 8) == 0) return normalised(read_png(file.get()));
    if (got >= 2 && magic[0] == 0xff && magic[1] == 0xd8) require_whole_jpeg(file.get());
    if (got >= 2 && magic[0] == 'P' && magic[1] >= '1' && magic[1] <= '7') return read_netpbm(file.get());
    file.reset();
    return read_through_module(path);
  } catch (const std::runtime_error& error) {
    fail(path, "read", error.what());
  }
}

void write_picture(const Picture& picture, const std::filesystem::path& path) {
  const std::size_t n = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.channels);
  write_rows(
      picture.width, picture.height, picture.channels,
      [&](int y, float* row) { std::copy_n(picture.samples.data() + n * static_cast<std::size_t>(y), n, row); }, path);
}

std::unique_ptr<PictureRows> open_rows(const std::filesystem::path& path) {
  require_picture_file(path);
  File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail(path, "open", std::strerror(errno));
  if (is_png(file.get())) {
    std::unique_ptr<PngFileRows> rows;
    try {
      rows = std::make_unique<PngFileRows>(path, std::move(file));
    } catch (const std::runtime_error& error) {
      fail(path, "read", error.what());
    }
    if (!rows->interlaced()) return rows;
  }
  return std::make_unique<WholePictureRows>(read_picture(path));
}

void write_rows(int width, int height, int channels, const std::function<void(int y, float* row)>& rows,
                const std::filesystem::path& path, int bits) {
  const Quantised shape{width, height, channels, bits, {}};
  const float most = static_cast<float>((1 << bits) - 1);
  std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(channels));
  const auto quantised = [&](int y, std::uint16_t* row) {
    rows(y, values.data());
    for (std::size_t i = 0; i < values.size(); ++i)
      row[i] = static_cast<std::uint16_t>(values[i] > 0 ? std::floor(std::min(values[i], 1.0f) * most + 0.5f) : 0.0f);
  };
  OutputOptions options;
  options.bits = bits;
  write_atomically(path, [&](std::FILE* file) { write_png(file, shape, options, quantised); });
}

}  // namespace verisim::image
