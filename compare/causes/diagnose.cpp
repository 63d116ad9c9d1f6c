#include "compare/causes/diagnose.h"

#include <map>

#include "compare/causes/families.h"

namespace verisim::compare {
namespace {

constexpr double kConvincing = 0.3;
constexpr double kTold = 0.6, kUnlikely = 0.6;
constexpr std::size_t kMax = 12;

constexpr double kRather = 0.75;
constexpr std::array kWhereAlone = {"specks", "few pixels", "edges"};
constexpr std::array kOfAll = {"ambient light", "light strength", "light color", "light moved"};

bool is_one_of(const auto& list, const Suspicion& s) {
  return std::find(list.begin(), list.end(), s.what) != list.end();
}

// An object that has moved takes its shadows and mirror images along, and a camera all of them.
void leave_to_objects(Suspicions& all) {
  constexpr double kSure = 0.6;
  constexpr std::array kMoves = {"object missing",   "object added",   "object moved",  "object scaled",
                                 "object rotated",   "camera moved",   "camera turned", "camera zoom",
                                 "camera stretched", "camera rotation"};
  constexpr std::array kFollow = {"shadows", "light",   "object shape",  "reflection", "transparency",
                                  "texture", "normals", "ambient light", "background", "highlights"};
  if (std::any_of(all.begin(), all.end(), [&](const Suspicion& s) { return s.sure > kSure && is_one_of(kMoves, s); }))
    for (Suspicion& s : all)
      if (is_one_of(kFollow, s)) s.sure *= kUnlikely;
}

// Whether all wrong pixels show one object, or the sky: then it is hardly the whole picture that has a fault.
bool one_is_wrong(const Case& c, const PixelTags& tags) {
  constexpr double kAll = 0.97, kLarge = 0.3;  // of the picture: others lie before it
  constexpr int kBorder = 1;                   // pixels, which show both sides
  return std::any_of(tags.tags.begin(), tags.tags.end(), [&](const PixelTags::Tag& tag) {
    if (tag.kind != "copy" && !is_sky(tag)) return false;
    const Mask mask = c.pixels_with(tags, [&](const PixelTags::Tag& other) { return &other == &tag; });
    const auto pixels = std::count(mask.begin(), mask.end(), 1);
    const bool large = static_cast<double>(pixels) > kLarge * static_cast<double>(c.size());
    return part_of_wrong(c, large ? mask : dilated(c, mask, kBorder)) > kAll;
  });
}

}  // namespace

std::vector<Suspicion> diagnose(const Picture& reference, const Picture& test, const PixelTags* reference_tags,
                                const PixelTags* test_tags) {
  const Case c(reference, test, {reference_tags, test_tags});
  Suspicions all;
  if (!(c.total > 0) || c.wrong_count == 0) return all;
  for (const auto family : {suspect_tone, suspect_filtering}) family(c, all);
  const bool of_one_object = !c.tags.both() && c.tags.any() && one_is_wrong(c, *c.tags.any());
  if (of_one_object)
    for (Suspicion& s : all) s.sure *= kUnlikely;
  suspect_regions(c, all);
  Suspicions specks;
  suspect_specks(c, specks);
  for (Suspicion& s : specks)
    s.sure *= of_one_object && is_one_of(kWhereAlone, s) ? kUnlikely : 1, all.push_back(std::move(s));
  // What happens to finished pictures is no suspect where the programs tell the difference before.
  if (told_by_terms(c).value_or(0) > kTold)
    for (Suspicion& s : all) s.sure *= kUnlikely;
  Suspicions framing;
  suspect_framing(c, framing);
  for (Suspicion& s : framing) s.sure *= of_one_object ? kUnlikely : 1, all.push_back(std::move(s));
  Suspicions terms;
  suspect_terms(c, terms);
  for (Suspicion& s : terms) s.sure *= of_one_object && is_one_of(kOfAll, s) ? kRather : 1, all.push_back(std::move(s));
  for (const auto family : {suspect_objects, suspect_features}) family(c, all);
  leave_to_objects(all);
  std::stable_sort(all.begin(), all.end(),
                   [](const Suspicion& a, const Suspicion& b) { return a.sure > b.sure + 1e-9; });
  // Of several parameters of one kind the best; of one part of the picture, too.
  Suspicions out;
  for (Suspicion& s : all) {
    if (!(s.sure >= kConvincing) || out.size() == kMax) break;
    const std::string subject = s.detail.substr(0, s.detail.find(": "));
    if (std::none_of(out.begin(), out.end(), [&](const Suspicion& better) {
          return better.what == s.what && better.detail.substr(0, better.detail.find(": ")) == subject;
        }))
      out.push_back(std::move(s));
  }
  return out;
}

}  // namespace verisim::compare
