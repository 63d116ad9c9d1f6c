#include "compare/regression/ignored.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/metrics/values.h"

namespace verisim::compare {
namespace {

void blacken(const std::vector<unsigned char>& mask, Picture& picture) {
  const auto channels = static_cast<std::size_t>(picture.channels);
  const bool alpha = channels == 2 || channels == 4;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    std::fill_n(picture.samples.begin() + static_cast<std::ptrdiff_t>(i * channels), channels, 0.0f);
    if (alpha) picture.samples[i * channels + channels - 1] = 1;
  }
}

void add_rectangle(const Crop& r, int width, int height, std::vector<unsigned char>& mask) {
  for (int y = std::max(0, r.y); y < std::min(height, r.y + r.height); ++y)
    for (int x = std::max(0, r.x); x < std::min(width, r.x + r.width); ++x)
      mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = 1;
}

void add_picture(const std::filesystem::path& file, int width, int height, std::vector<unsigned char>& mask) {
  const Picture picture = image::read_picture(file);
  if (picture.width != width || picture.height != height)
    throw std::runtime_error(fmt::format("{}: the mask has {}x{} pixels, the picture {}x{}", file.string(),
                                         picture.width, picture.height, width, height));
  const Values values(picture);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (values.luma(x, y) > 127.5)
        mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = 1;
}

void add_objects(const std::vector<std::string>& names, const PixelTags& tags, std::vector<unsigned char>& mask) {
  if (tags.step != 1 || tags.set_of.size() != mask.size())
    throw std::runtime_error("'ignore' names an object, but not every pixel's object is known");
  std::vector<bool> of_set;
  for (const std::vector<int>& set : tags.sets)
    of_set.push_back(std::any_of(set.begin(), set.end(), [&](int i) {
      const PixelTags::Tag& tag = tags.tags.at(static_cast<std::size_t>(i));
      return tag.kind == "object" && std::any_of(names.begin(), names.end(), [&](const std::string& name) {
               return tag.name.find(name) != std::string::npos;
             });
    }));
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] |= of_set.at(static_cast<std::size_t>(tags.set_of[i]));
}

}  // namespace

std::vector<unsigned char> ignore_pixels(const Ignored& ignored, const PixelTags* tags, Picture& reference,
                                         Picture& test) {
  require_same_size(reference, test);
  std::vector<unsigned char> mask(static_cast<std::size_t>(test.width) * static_cast<std::size_t>(test.height));
  for (const Crop& rectangle : ignored.rectangles) add_rectangle(rectangle, test.width, test.height, mask);
  if (!ignored.mask.empty()) add_picture(ignored.mask, test.width, test.height, mask);
  if (!ignored.objects.empty()) {
    if (!tags) throw std::runtime_error("'ignore' names an object, but nothing says which pixels show it");
    add_objects(ignored.objects, *tags, mask);
  }
  blacken(mask, reference), blacken(mask, test);
  return mask;
}

}  // namespace verisim::compare
