// What the wrong pixels show more often than the right ones (compare/metrics/blame.h), as suspects.
#include <fmt/format.h>

#include "compare/causes/families.h"

namespace verisim::compare {
namespace {

// Pearson's correlation of having the tag with being wrong or, where nearly all pixels are, with how wrong they are.
double correlation(const Case& c, const Mask& mask, const Mask& counted) {
  const bool by_size = static_cast<double>(c.wrong_count) > 0.8 * static_cast<double>(c.size());
  double n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (!counted[i]) continue;
    const double u = mask[i], v = by_size ? std::sqrt(c.squared[i]) : c.wrong[i];
    ++n, x += u, y += v, xx += u * u, yy += v * v, xy += u * v;
  }
  const double spread = (n * xx - x * x) * (n * yy - y * y);
  return spread > 0 ? (n * xy - x * y) / std::sqrt(spread) : 0;
}

// Of few wrong pixels the correlation says little. How much more often they have the tag than the right ones do, unless
// that may be chance.
double excess(const Case& c, const Mask& mask, const Mask& counted) {
  double wrong = 0, right = 0, wrong_with = 0, right_with = 0;
  for (std::size_t i = 0; i < c.size(); ++i)
    if (counted[i]) (c.wrong[i] ? wrong : right) += 1, (c.wrong[i] ? wrong_with : right_with) += mask[i];
  if (wrong == 0) return 0;
  const double usual = right > 0 ? right_with / right : 0;
  return (wrong_with / wrong - usual) * (1 - std::pow(usual, wrong_with));
}

// How much of the squared difference of the counted pixels lies in the mask.
double share_within(const Case& c, const Mask& mask, const Mask& counted) {
  double all = 0, with = 0;
  for (std::size_t i = 0; i < c.size(); ++i)
    if (counted[i]) all += c.squared[i], with += mask[i] ? c.squared[i] : 0;
  return all > 0 ? with / all : 0;
}

// Where a term of the colour can be seen.
Mask bright(const Pixels& light) {
  constexpr float kSeen = 2e-3f;
  Mask out(light.size());
  for (std::size_t i = 0; i < light.size(); ++i) out[i] = std::max({light[i][0], light[i][1], light[i][2]}) > kSeen;
  return out;
}

// An effect says more than where it is seen: photons, radiosity, subsurface. A texture of one object says more than
// that it is this object's surface, and what casts a shadow more than that there is one; the sky in mirrors, more than
// that there are mirrors. That it is lit says less of the only object that is.
constexpr double kEffect = 0.85, kOwned = 0.72, kSky = 0.67, kOther = 0.65, kOnlyOne = 0.5;

bool is_shadow(const PixelTags::Tag& tag) { return tag.kind == "light" && tag.name.starts_with("in the shadow"); }

const char* suspect_of(const PixelTags::Tag& tag) {
  if (tag.kind == "effect") return tag.name.c_str();
  if (tag.kind == "texture") return tag.name.starts_with("normal") ? "normals" : "texture";
  if (tag.kind == "light") return is_shadow(tag) ? "shadows" : "light";
  if (tag.kind == "feature") return tag.name.starts_with("noise") ? "noise functions" : "feature";
  if (tag.kind == "secondary object") return is_sky(tag) ? "background" : "reflection or refraction";
  if (tag.kind == "shape") return "shape";
  if (tag.kind == "passed object") return "object missing";
  if (tag.kind == "caster") return "shadows";
  return nullptr;
}

// Suspects by where they are seen.
class Sightings {
 public:
  Sightings(const Case& c, Suspicions& out) : c_(c), out_(out), direct_(directly_seen(c, *c.tags.any())) {}

  // `in_mirrors`: what is seen in mirrors and through glass counts, too.
  void suspect(const char* what, const std::string& detail, const Mask& mask, double weight, bool in_mirrors = false) {
    constexpr double kLeast = 0.3;
    const Mask& counted = in_mirrors ? all_ : direct_;
    const double found = std::max(correlation(c_, mask, counted), excess(c_, mask, counted));
    if (found < kLeast) return;
    Suspicion s = c_.placed(what, detail, mask, 1);
    // What is wrong in mirrors only may be another's fault; all that is wrong should not.
    constexpr double kOfCounted = 0.6;
    s.sure =
        weight * found * std::sqrt(share_within(c_, mask, counted)) * (kOfCounted + (1 - kOfCounted) * s.explained);
    out_.push_back(std::move(s));
  }

 private:
  const Case& c_;
  Suspicions& out_;
  const Mask all_ = Mask(c_.size(), 1), direct_;
};

// The only object of a kind of tags ("object") whose name begins so; null: none, or several.
const PixelTags::Tag* only_object(const PixelTags& tags, const std::string& beginning) {
  const PixelTags::Tag* only = nullptr;
  for (const PixelTags::Tag& tag : tags.tags) {
    if (tag.kind != "copy" || !tag.name.starts_with(beginning)) continue;
    if (only) return nullptr;
    only = &tag;
  }
  return only;
}

constexpr const char* kHere = "seen where pixels are wrong";

}  // namespace

void suspect_features(const Case& c, Suspicions& out) {
  if (!c.tags.any()) return;
  const PixelTags& tags = *c.tags.any();
  Sightings seen(c, out);
  for (const PixelTags::Tag& tag : tags.tags) {
    const char* what = suspect_of(tag);
    if (!what) continue;
    if (tag.kind == "shape" && only_object(tags, tag.name + " (")) continue;  // the object itself says more
    const Mask mask = c.pixels_with(tags, [&](const PixelTags::Tag& other) { return &other == &tag; });
    const bool effect = tag.kind == "effect", secondary = tag.kind == "secondary object";
    const bool lit = tag.kind == "light" && !is_shadow(tag);
    const std::string owner = tag.kind == "texture" || lit ? owner_of(c, tags, mask) : "";
    seen.suspect(what,
                 effect                 ? kHere
                 : tag.kind == "caster" ? "of " + tag.name
                                        : tag.name + (owner.empty() || lit ? "" : " of " + owner),
                 mask,
                 effect                                              ? kEffect
                 : lit && !owner.empty()                             ? kOnlyOne
                 : !owner.empty() && !tag.name.starts_with("normal") ? kOwned
                 : tag.kind == "caster"                              ? kOwned
                 : secondary && is_sky(tag)                          ? kSky
                                                                     : kOther,
                 secondary || tag.kind == "feature");
  }
  for (const PixelTags::Tag& tag : tags.tags)
    if (tag.kind == "copy") {
      const Mask mask = c.pixels_with(tags, [&](const PixelTags::Tag& other) { return &other == &tag; });
      // What is wrong around it is not its surface's fault.
      seen.suspect("object", tag.name.substr(0, tag.name.rfind(" at <")) + ": its surface", mask,
                   weight::kPlace * share_of(c, mask));
    }
  // An object that casts no shadow does so in the light of all lamps.
  seen.suspect("shadows", "in the shadow of any light", c.pixels_with(tags, is_shadow), kOther);
  for (const PixelTags::Part& part : tags.parts)
    if (part.kind == "highlights") seen.suspect("highlights", kHere, bright(c.numbers_of(tags, part.light)), kEffect);
}

}  // namespace verisim::compare
