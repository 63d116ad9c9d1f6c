// What the wrong pixels show more often than the right ones (compare/metrics/blame.h), as suspects.
#include <fmt/format.h>

#include "compare/causes/families.h"

namespace verisim::compare {
namespace {

// Pearson's correlation of having the tag with being wrong or, where nearly all pixels are, with how wrong they are.
double correlation(const Case& c, const Mask& mask) {
  const bool by_size = static_cast<double>(c.wrong_count) > 0.8 * static_cast<double>(c.size());
  double n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double u = mask[i], v = by_size ? std::sqrt(c.squared[i]) : c.wrong[i];
    ++n, x += u, y += v, xx += u * u, yy += v * v, xy += u * v;
  }
  const double spread = (n * xx - x * x) * (n * yy - y * y);
  return spread > 0 ? (n * xy - x * y) / std::sqrt(spread) : 0;
}

// Of few wrong pixels the correlation says little. How much more often they have the tag than the right ones do, unless
// that may be chance.
double excess(const Case& c, const Mask& mask) {
  const double right = part_of_right(c, mask);
  std::size_t with = 0;
  for (std::size_t i = 0; i < c.size(); ++i) with += mask[i] && c.wrong[i];
  const double wrong = static_cast<double>(with) / static_cast<double>(c.wrong_count);
  return (wrong - right) * (1 - std::pow(right, static_cast<double>(with)));
}

// An effect says more than where it is seen: photons, radiosity, subsurface.
constexpr double kEffect = 0.85, kOther = 0.65;

const char* suspect_of(const PixelTags::Tag& tag) {
  if (tag.kind == "effect") return tag.name.c_str();
  if (tag.kind == "texture") return tag.name.starts_with("normal") ? "normals" : "texture";
  if (tag.kind == "light") return tag.name.starts_with("in the shadow") ? "shadows" : "light";
  if (tag.kind == "feature") return tag.name.starts_with("noise") ? "noise functions" : "feature";
  if (tag.kind == "secondary object") return "reflection or refraction";
  if (tag.kind == "shape") return "shape";
  if (tag.kind == "passed object") return "object missing";
  return nullptr;
}

}  // namespace

void suspect_features(const Case& c, Suspicions& out) {
  if (!c.tags.any()) return;
  const PixelTags& tags = *c.tags.any();
  for (const PixelTags::Tag& tag : tags.tags) {
    const char* what = suspect_of(tag);
    if (!what) continue;
    const Mask mask = c.pixels_with(tags, [&](const PixelTags::Tag& other) { return &other == &tag; });
    const double strength = std::max(correlation(c, mask), excess(c, mask));
    if (strength < 0.3) continue;
    Suspicion s = c.placed(what, tag.kind == "effect" ? "seen where pixels are wrong" : tag.name, mask, 1);
    s.sure = (tag.kind == "effect" ? kEffect : kOther) * strength * std::sqrt(s.explained);
    out.push_back(std::move(s));
  }
}

}  // namespace verisim::compare
