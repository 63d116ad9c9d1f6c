#include "tracer/shapes/heights/height_map.h"

#include <algorithm>
#include <cmath>

namespace verisim::shapes {

std::uint16_t height_of_pixel(const Image& image, int x, int y) {
  if (image.indexed()) return static_cast<std::uint16_t>(image.index(x, y) * 256);
  const Color c = image.at(x, y);
  const auto wrapped = [](double v) {
    return std::isfinite(v) ? static_cast<std::uint16_t>(static_cast<std::int64_t>(v) & 0xffff) : std::uint16_t{0};
  };
  if (image.grey) {
    if (image.type == ImageType::png && !image.sixteen_bit && !image.has_alpha) {
      // Such files go through a luma of three equal channels in binary32, which is often one unit in the last place too
      // small.
      const float g = c.r;
      const float red = g * 0.297f, green = g * 0.589f, blue = g * 0.114f;
      const float luma = red + green + blue;
      return static_cast<std::uint16_t>(static_cast<int>(luma * 255.0f) * 257);
    }
    return wrapped(std::clamp(static_cast<double>(c.r), 0.0, 1.0) * 65535 +
                   0.01);  // 0.01: the float nearest to n / 65535 must give n
  }
  // Double weights of binary32 channels: of a grey n the sum is often a little less than n, and the height n - 1.
  if (image.sixteen_bit) return wrapped((0.297 * c.r + 0.589 * c.g + 0.114 * c.b) * 65535);
  return wrapped((static_cast<double>(c.r) * 256 + c.g) * 255 + 1e-3);
}

std::shared_ptr<const scene::HeightMap> height_map(const Image& image) {
  auto map = std::make_shared<scene::HeightMap>();
  map->width = image.width, map->depth = image.height;
  map->heights.reserve(static_cast<std::size_t>(map->width) * static_cast<std::size_t>(map->depth));
  for (int k = 0; k < map->depth; ++k)
    for (int i = 0; i < map->width; ++i) map->heights.push_back(height_of_pixel(image, i, map->depth - 1 - k));
  if (!map->heights.empty()) {
    const auto [lowest, highest] = std::minmax_element(map->heights.begin(), map->heights.end());
    map->lowest = *lowest, map->highest = *highest;
  }
  return map;
}

}  // namespace verisim::shapes
