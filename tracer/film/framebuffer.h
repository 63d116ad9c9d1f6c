// The picture while it is made: linear colours, before gamma and quantisation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tracer/film/pixels.h"

namespace verisim::render {

// Linear working-space radiance, premultiplied; t is the transmit of the pixel (alpha = 1 - t).
struct Framebuffer {
  int width = 0, height = 0;
  Pixels pixels;                   // row 0 is the top
  std::vector<std::uint8_t> done;  // per pixel: rendered in this run
  PixelColor& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
  const PixelColor& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

}  // namespace verisim::render
