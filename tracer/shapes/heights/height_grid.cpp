#include "tracer/shapes/heights/height_grid.h"

#include <algorithm>
#include <cmath>

#include "tracer/image/image.h"
#include "tracer/shapes/shared_payload.h"

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

std::shared_ptr<const HeightGrid> HeightGrid::of(const std::shared_ptr<const scene::HeightField>& field) {
  return shared_payload<HeightGrid>(field, [&] { return std::make_shared<HeightGrid>(*field); });
}

HeightGrid::HeightGrid(const scene::HeightField& field) : water_(field.water_level * 65536) {
  const Image* image = field.image.image.get();
  if (!image || image->width < 1 || image->height < 1) return;
  width_ = image->width, depth_ = image->height;
  heights_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(depth_));
  std::size_t n = 0;
  for (int k = 0; k < depth_; ++k) {
    for (int i = 0; i < width_; ++i) {
      const std::uint16_t h = height_of_pixel(*image, i, depth_ - 1 - k);
      heights_[n++] = h;
      lowest_ = std::min<int>(lowest_, h), highest_ = std::max<int>(highest_, h);
    }
  }
  if (empty()) return;
  build_pyramid();
  if (field.smooth) build_normals();
}

void HeightGrid::build_pyramid() {
  levels_.emplace_back();  // level 0 is the heights themselves
  int w = width_ - 1, d = depth_ - 1;
  const auto cell = [&](int i, int k) {
    const auto [low, high] = std::minmax({at(i, k), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)});
    return std::pair(low, high);
  };
  const auto extremes = [&](int level, int i, int k) {
    const Block& b = block(level, i, k);
    return std::pair<int, int>(*std::min_element(b.low, b.low + kChildren),
                               *std::max_element(b.high, b.high + kChildren));
  };
  for (int level = 1; level == 1 || w > 1 || d > 1; ++level) {
    Level next{(w - 1) / 4 + 1, (d - 1) / 4 + 1, {}};
    next.blocks.resize(static_cast<std::size_t>(next.width) * static_cast<std::size_t>(next.depth));
    std::size_t n = 0;
    for (int k = 0; k < next.depth; ++k) {
      for (int i = 0; i < next.width; ++i) {
        Block& b = next.blocks[n++];
        for (int c = 0; c < kChildren; ++c) {
          const int x = 4 * i + column(c), z = 4 * k + row(c);
          const auto [low, high] = x >= w || z >= d ? std::pair(65535, 0)
                                   : level == 1     ? cell(x, z)
                                                    : extremes(level - 1, x, z);
          b.low[c] = static_cast<std::uint16_t>(low), b.high[c] = static_cast<std::uint16_t>(high);
        }
      }
    }
    w = next.width, d = next.depth;
    levels_.push_back(std::move(next));
  }
}

// The sum of the unit normals of the up to four triangles around each sample, cut to multiples of 1/32767. Heights
// count 65536 to a unit, so the vertical part is small and coarse, as it is in POV-Ray.
void HeightGrid::build_normals() {
  normals_.resize(heights_.size());
  constexpr int kQuadrants[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  for (int k = 0; k < depth_; ++k) {
    for (int i = 0; i < width_; ++i) {
      Vec3 sum(0, 0, 0);
      for (const auto& [dx, dz] : kQuadrants) {
        if (i + dx < 0 || i + dx >= width_ || k + dz < 0 || k + dz >= depth_) continue;
        const double h = at(i, k);
        sum += normalize(Vec3((h - at(i + dx, k)) * dx, 1, (h - at(i, k + dz)) * dz));
      }
      const double size = length(sum);
      const Vec3 n = size < kEpsilon ? Vec3(0, 1, 0) : sum / size;
      auto& stored =
          normals_[static_cast<std::size_t>(k) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(i)];
      for (int c = 0; c < 3; ++c) stored[static_cast<std::size_t>(c)] = static_cast<std::int16_t>(32767 * n[c]);
    }
  }
}

}  // namespace verisim::shapes
