// Few wrong pixels, and edges: where, and mostly no more.
#include <fmt/format.h>

#include "compare/causes/families.h"
#include "compare/metrics/edges.h"

namespace verisim::compare {
namespace {

// Wrong pixels with at most one wrong neighbour.
void lone_pixels(const Case& c, Suspicions& out) {
  constexpr double kMaxPart = 0.1;
  if (c.wrong_count == 0 || static_cast<double>(c.wrong_count) > kMaxPart * static_cast<double>(c.size())) return;
  Mask lone(c.size());
  std::size_t count = 0, white = 0, black = 0;
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x) {
      if (!c.wrong[c.at(x, y)]) continue;
      int neighbours = -1;
      for (int j = std::max(0, y - 1); j <= std::min(c.height - 1, y + 1); ++j)
        for (int i = std::max(0, x - 1); i <= std::min(c.width - 1, x + 1); ++i) neighbours += c.wrong[c.at(i, j)];
      if (neighbours > 1) continue;
      const Pixel& q = c.test[c.at(x, y)];
      lone[c.at(x, y)] = 1, ++count;
      white += *std::min_element(q.begin(), q.end()) > 250, black += *std::max_element(q.begin(), q.end()) < 5;
    }
  if (count < 0.5 * static_cast<double>(c.wrong_count)) return;
  const char* what = white > 0.8 * static_cast<double>(count)   ? "white"
                     : black > 0.8 * static_cast<double>(count) ? "black"
                                                                : "wrong";
  constexpr std::size_t kMany = 8;  // of fewer it is no pattern that they are alone
  Suspicion s = c.placed("specks", fmt::format("{} lone {} pixels", count, what), lone,
                         count >= kMany || !c.tags.any() ? weight::kPlace : weight::kVague);
  out.push_back(std::move(s));
}

void not_numbers(const Case& c, Suspicions& out) {
  if (c.nan_count == 0) return;
  Mask mask(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) mask[i] = c.squared[i] >= 3 * 255.0f * 255.0f;
  out.push_back(c.placed("NaN", fmt::format("{} pixels are not finite in one of the pictures", c.nan_count), mask,
                         weight::kRepaired));
}

void edges(const Case& c, Suspicions& out) {
  Picture picture;
  picture.width = c.width, picture.height = c.height, picture.bits = 16, picture.channels = 3;
  for (const Pixel& p : c.reference)
    for (float v : p) picture.samples.push_back(v / 255);
  const Mask mask = edge_mask(Values(picture));
  const auto pixels = static_cast<double>(std::count(mask.begin(), mask.end(), 1)) / static_cast<double>(c.size());
  const double share = share_of(c, mask);
  // Where most of the picture is edges, that the difference lies there says nothing.
  if (share < 0.95 || pixels > 0.5 || share < 2 * pixels) return;
  Suspicion s = c.placed("edges",
                         fmt::format("{:.1f} % of the squared difference lies on edges, {:.1f} % of the pixels",
                                     100 * share, 100 * pixels),
                         mask, 1);
  s.sure = weight::kVague * share * (1 - pixels);
  out.push_back(std::move(s));
}

void few_pixels(const Case& c, Suspicions& out) {
  std::vector<float> errors = c.squared;
  const std::size_t few = std::max<std::size_t>(1, errors.size() / 100);
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(few) - 1, errors.end(),
                   std::greater<>());
  const float least = errors[few - 1];
  Mask mask(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) mask[i] = c.squared[i] >= least && c.squared[i] > 0;
  const double share = share_of(c, mask);
  if (share < 0.95) return;
  Suspicion s = c.placed(
      "few pixels", fmt::format("1 % of the pixels holds {:.1f} % of the squared difference", 100 * share), mask, 1);
  s.sure = weight::kVague * share;
  out.push_back(std::move(s));
}

// Where the renderer knows of several surfaces in one place, and mostly there, pixels are wrong.
void known_coincidences(const Case& c, Suspicions& out) {
  if (!c.tags.any()) return;
  for (const PixelTags::Tag& tag : c.tags.any()->tags) {
    if (tag.kind != "coincidence") continue;
    const Mask mask = c.pixels_with(*c.tags.any(), [&](const PixelTags::Tag& other) { return &other == &tag; });
    Suspicion s = c.placed("coincident surfaces", tag.name + " are in the same place", mask, 1);
    // Of a whole picture of such surfaces most pixels are right, and yet they are what is special there.
    constexpr double kEverywhere = 0.75;
    s.sure = weight::kKnown * s.explained * (1 - (1 - kEverywhere) * part_of_right(c, mask));
    out.push_back(std::move(s));
  }
}

// Two objects in each other's place, pixel by pixel: which of two surfaces in one place is seen is chance.
void exchanged_surfaces(const Case& c, Suspicions& out) {
  if (!c.tags.both()) return;
  const auto object_of = [](const PixelTags& tags, int set) {
    if (set >= 0)
      for (int tag : tags.sets[static_cast<std::size_t>(set)])
        if (tags.tags[static_cast<std::size_t>(tag)].kind == "object")
          return tags.tags[static_cast<std::size_t>(tag)].name;
    return std::string();
  };
  std::map<std::pair<std::string, std::string>, std::array<std::size_t, 2>> pairs;
  std::map<std::pair<std::string, std::string>, Mask> masks;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (!c.wrong[i]) continue;
    const std::string was = object_of(*c.tags.reference, c.set_of(*c.tags.reference, i)),
                      is = object_of(*c.tags.test, c.set_of(*c.tags.test, i));
    if (was == is || was.empty() || is.empty()) continue;
    const std::pair<std::string, std::string> key = std::minmax(was, is);
    ++pairs[key][was < is];
    Mask& mask = masks.try_emplace(key, Mask(c.size())).first->second;
    mask[i] = 1;
  }
  for (const auto& [names, count] : pairs) {
    if (std::min(count[0], count[1]) < 0.2 * static_cast<double>(count[0] + count[1]) || count[0] + count[1] < 8)
      continue;
    Suspicion s = c.placed("coincident surfaces",
                           fmt::format("{} and {} are seen in each other's place", names.first, names.second),
                           masks[names], weight::kPlace);
    out.push_back(std::move(s));
  }
}

}  // namespace

void suspect_specks(const Case& c, Suspicions& out) {
  not_numbers(c, out), lone_pixels(c, out), edges(c, out), few_pixels(c, out);
  known_coincidences(c, out), exchanged_surfaces(c, out);
}

}  // namespace verisim::compare
