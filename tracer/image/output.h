// From framebuffer to file: gamma, quantisation, dithering, alpha and formats (spec 02 section 4). Files are written to
// a temporary name and renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <map>
#include <optional>
#include <string>

#include "tracer/film/framebuffer.h"
#include "tracer/scene/scene.h"

namespace verisim::image {

enum class Format : std::uint8_t { png, tga, tga_rle, ppm, bmp, jpeg, exr, hdr, tiff };
const char* extension_of(Format format);  // with the dot, as POV-Ray names files
enum class Dither : std::uint8_t { none, bayer2, bayer3, bayer4, diffusion1d, diffusion2d, floyd_steinberg };

struct OutputOptions {
  Format format = Format::png;
  int bits = 8;  // per channel, 5..16
  bool alpha = false, greyscale = false;
  scene::Gamma working = scene::Gamma::power;  // of the scene (spec 02 4.1)
  double working_gamma = 1;
  bool file_srgb = true;
  double file_gamma = 1;  // when not sRGB
  Dither dither = Dither::none;
  int compression = 0;  // JPEG quality
  std::map<std::string, std::string> metadata;
  // When it was made, in seconds since 1970 (UTC), for PNG, TIFF, JPEG and OpenEXR. Nothing: no file tells, so that the
  // same picture is the same file.
  std::optional<std::int64_t> time;
};

// The linear colours of a picture, asked for row by row from the top: of a framebuffer, or from files that hold more
// than memory does. A row is good until the next one is asked for.
struct ColorRows {
  int width = 0, height = 0;
  std::function<const render::PixelColor*(int y)> row;
};
// The framebuffer must outlive them.
ColorRows rows_of(const render::Framebuffer& framebuffer);

// Quantised samples as they go into an integer file: `channels` per pixel (1, 3 or 4), row 0 at the top.
struct Quantised {
  int width = 0, height = 0, channels = 3, bits = 8;
  std::vector<std::uint16_t> samples;
};
Quantised quantise(const ColorRows& rows, const OutputOptions& options);
Quantised quantise(const render::Framebuffer& framebuffer, const OutputOptions& options);

// The same row by row: a second picture in memory would be as large as the first. The options must outlive it.
class Quantiser {
 public:
  Quantiser(ColorRows rows, const OutputOptions& options);
  ~Quantiser();
  Quantiser(const Quantiser&) = delete;
  Quantiser& operator=(const Quantiser&) = delete;
  Quantised shape() const;                  // without samples
  void row(int y, std::uint16_t* samples);  // in order, from 0: errors are diffused to rows below

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Throws std::runtime_error naming the file and the reason. path "-" is standard output.
void write(const ColorRows& rows, const std::filesystem::path& path, const OutputOptions& options);
void write(const render::Framebuffer& framebuffer, const std::filesystem::path& path, const OutputOptions& options);

// A picture read back for comparison: values 0..1 as stored in the file (no gamma applied) for integer formats, floats
// as they are for EXR and HDR.
struct Picture {
  int width = 0, height = 0, channels = 3;
  bool is_float = false;
  int bits = 8;
  std::vector<float> samples;
};
Picture read_picture(const std::filesystem::path& path);
void write_picture(const Picture& picture, const std::filesystem::path& path);  // 8-bit PNG

}  // namespace verisim::image
