// From a picture to the heights of a height_field (spec 04 section 5).
#pragma once

#include <cstdint>
#include <memory>

#include "tracer/image/image.h"
#include "tracer/scene/object.h"

namespace verisim::shapes {

// Height 0 .. 65535 of pixel (x, y).
std::uint16_t height_of_pixel(const Image& image, int x, int y);

std::shared_ptr<const scene::HeightMap> height_map(const Image& image);

}  // namespace verisim::shapes
