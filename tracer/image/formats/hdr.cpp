#include "tracer/image/formats/hdr.h"

#include <array>
#include <cmath>

#include "tracer/image/dither.h"
#include "tracer/image/gamma.h"

namespace verisim::image {
namespace {

// Shared exponent and three mantissas. The dither's offset counts in units of a mantissa (probed with constant
// backgrounds).
std::array<std::uint8_t, 4> encode(const float (&color)[3], float offset) {
  const float largest = std::max({color[0], color[1], color[2]});
  if (!(largest > 1e-32f)) return {};
  int exponent = 0;
  std::frexp(largest, &exponent);
  const float scale = std::ldexp(1.0f, 8 - exponent);
  std::array<std::uint8_t, 4> out{0, 0, 0, static_cast<std::uint8_t>(std::clamp(exponent + 128, 0, 255))};
  for (int c = 0; c < 3; ++c)
    out[c] = static_cast<std::uint8_t>(std::clamp(std::floor(color[c] * scale + offset), 0.0f, 255.0f));
  return out;
}

// As POV-Ray reads them: half a mantissa more, which is what the truncation took away on average.
float decode(const std::array<std::uint8_t, 4>& code, int channel) {
  return code[3] == 0 ? 0.0f : std::ldexp(static_cast<float>(code[channel]) + 0.5f, code[3] - 136);
}

// The run-length code of Radiance: each component of a row on its own, runs of more than three.
void append_runs(const std::vector<std::array<std::uint8_t, 4>>& row, int component, std::vector<std::uint8_t>& out) {
  const std::size_t n = row.size();
  const auto run_at = [&](std::size_t i) {
    std::size_t j = i + 1;
    while (j < n && j - i < 127 && row[j][component] == row[i][component]) ++j;
    return j - i;
  };
  for (std::size_t i = 0; i < n;) {
    if (const std::size_t run = run_at(i); run > 3) {
      out.push_back(static_cast<std::uint8_t>(128 + run));
      out.push_back(row[i][component]);
      i += run;
      continue;
    }
    std::size_t end = i;
    while (end < n && end - i < 128 && run_at(end) <= 3) ++end;
    out.push_back(static_cast<std::uint8_t>(end - i));
    for (; i < end; ++i) out.push_back(row[i][component]);
  }
}

}  // namespace

void write_hdr(std::FILE* file, const ColorRows& rows, const OutputOptions& options) {
  const OutputCurve to_linear(options.working, options.working_gamma, Curve::identity());
  const int width = rows.width, height = rows.height;
  std::fputs("#?RADIANCE\n", file);
  for (const auto& [key, value] : options.metadata)
    std::fprintf(file, "%s=%s\n", key == "Software" ? "SOFTWARE" : key.c_str(), value.c_str());
  std::fprintf(file, "FORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n", height, width);
  Diffusion diffusion(options.dither, width, 3);
  std::vector<std::array<std::uint8_t, 4>> row(static_cast<std::size_t>(width));
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < height; ++y) {
    const render::PixelColor* const pixels = rows.row(y);
    for (int x = 0; x < width; ++x) {
      const render::PixelColor& pixel = pixels[x];
      float color[3] = {to_linear.encode(pixel.r), to_linear.encode(pixel.g), to_linear.encode(pixel.b)};
      if (options.greyscale) color[0] = color[1] = color[2] = to_linear.encode(pixel.grey());
      if (diffuses(options.dither))
        for (int c = 0; c < 3; ++c) color[c] += diffusion.take(x, c);
      row[static_cast<std::size_t>(x)] = encode(color, bayer_offset(options.dither, x, y));
      if (diffuses(options.dither))
        for (int c = 0; c < 3; ++c)
          diffusion.give(x, c, std::max(color[c], 0.0f) - decode(row[static_cast<std::size_t>(x)], c));
    }
    bytes.clear();
    if (width >= 8 && width < 32768) {
      bytes = {2, 2, static_cast<std::uint8_t>(width >> 8), static_cast<std::uint8_t>(width & 255)};
      for (int component = 0; component < 4; ++component) append_runs(row, component, bytes);
    } else {
      for (const auto& pixel : row) bytes.insert(bytes.end(), pixel.begin(), pixel.end());
    }
    std::fwrite(bytes.data(), 1, bytes.size(), file);
  }
}

}  // namespace verisim::image
