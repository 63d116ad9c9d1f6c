#include "tracer/image/output.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "tracer/image/hdr.h"
#include "tracer/image/module_files.h"
#include "tracer/image/netpbm.h"
#include "tracer/image/png.h"

namespace verisim::image {
namespace {

struct FileCloser {
  void operator()(std::FILE* f) const { std::fclose(f); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& action, const std::string& reason) {
  throw std::runtime_error("cannot " + action + " '" + path.string() + "': " + reason);
}

// Runs `body` on a temporary file beside `path` and renames it when all went well: readers never see half a picture.
template <class Body>
void write_atomically(const std::filesystem::path& path, Body body) {
  if (path == "-") {
    body(stdout);
    if (std::fflush(stdout) != 0) fail("standard output", "write", std::strerror(errno));
    return;
  }
  // Devices and pipes are written in place.
  std::error_code ignored;
  const bool in_place = std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
  std::filesystem::path temporary = path;
  if (!in_place) temporary += "." + std::to_string(::getpid()) + ".tmp";
  File file(std::fopen(temporary.c_str(), "wb"));
  if (!file) fail(path, "create", std::strerror(errno));
  try {
    body(file.get());
    if (std::fflush(file.get()) != 0 || std::ferror(file.get())) throw std::runtime_error(std::strerror(errno));
    file.reset();
    if (!in_place) std::filesystem::rename(temporary, path);
  } catch (const std::exception& error) {
    if (!in_place) std::filesystem::remove(temporary, ignored);
    fail(path, "write", error.what());
  }
}

// The module writes by name, so it gets a temporary file of the right type; standard output receives a copy of it.
void write_module_file(const render::Framebuffer& framebuffer, const std::filesystem::path& path, const OutputOptions& options) {
  const bool to_stdout = path == "-";
  std::filesystem::path temporary = to_stdout ? std::filesystem::temp_directory_path() / "verisim" : path;
  temporary += "." + std::to_string(::getpid()) + ".tmp" + extension_of(options.format);
  std::error_code ignored;
  try {
    write_through_module(framebuffer, temporary, options);
    if (to_stdout) {
      File file(std::fopen(temporary.c_str(), "rb"));
      if (!file) throw std::runtime_error(std::strerror(errno));
      char buffer[65536];
      for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, file.get())) > 0;)
        if (std::fwrite(buffer, 1, n, stdout) != n) throw std::runtime_error(std::strerror(errno));
      std::filesystem::remove(temporary, ignored);
    } else {
      std::filesystem::rename(temporary, path);
    }
  } catch (const std::exception& error) {
    std::filesystem::remove(temporary, ignored);
    fail(path, "write", error.what());
  }
}

Picture normalised(const Quantised& in) {
  Picture out{in.width, in.height, in.channels, false, in.bits, {}};
  const float scale = 1.0f / static_cast<float>((1 << in.bits) - 1);
  out.samples.resize(in.samples.size());
  for (std::size_t i = 0; i < in.samples.size(); ++i) out.samples[i] = static_cast<float>(in.samples[i]) * scale;
  return out;
}

}  // namespace

void write(const render::Framebuffer& framebuffer, const std::filesystem::path& path, const OutputOptions& options) {
  if (options.format == Format::hdr) return write_atomically(path, [&](std::FILE* file) { write_hdr(file, framebuffer, options); });
  if (options.format != Format::png && options.format != Format::ppm) return write_module_file(framebuffer, path, options);
  const Quantised picture = quantise(framebuffer, options);
  write_atomically(path, [&](std::FILE* file) { options.format == Format::png ? write_png(file, picture, options) : write_ppm(file, picture, options); });
}

Picture read_picture(const std::filesystem::path& path) {
  File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail(path, "open", std::strerror(errno));
  unsigned char magic[8] = {};
  const std::size_t got = std::fread(magic, 1, sizeof magic, file.get());
  std::rewind(file.get());
  try {
    if (got == 8 && std::memcmp(magic, "\x89PNG\r\n\x1a\n", 8) == 0) return normalised(read_png(file.get()));
    if (got >= 2 && magic[0] == 'P' && magic[1] >= '1' && magic[1] <= '7') return read_netpbm(file.get());
    file.reset();
    return read_through_module(path);
  } catch (const std::runtime_error& error) {
    fail(path, "read", error.what());
  }
}

void write_picture(const Picture& picture, const std::filesystem::path& path) {
  Quantised q{picture.width, picture.height, picture.channels, 8, {}};
  q.samples.reserve(picture.samples.size());
  for (float v : picture.samples) q.samples.push_back(static_cast<std::uint16_t>(v > 0 ? std::floor(std::min(v, 1.0f) * 255.0f + 0.5f) : 0.0f));
  OutputOptions options;
  write_atomically(path, [&](std::FILE* file) { write_png(file, q, options); });
}

}  // namespace verisim::image
