#include "parser/keywords/keywords.h"

#include <algorithm>
#include <array>
#include <map>

namespace verisim::parser {
namespace {

const KeywordSection* const kSections[] = {&kDirectives, &kFunctions, &kShapes, &kModifiers,  &kTextures, &kPatterns,
                                           &kImages,     &kLights,    &kCamera, &kAtmosphere, &kSettings};

struct Group {
  std::string_view name, places;
};

#define VERISIM_OBJECT_BLOCKS                                                                             \
  "bicubic_patch blob box composite cone cubic cylinder difference disc height_field intersection "       \
  "isosurface julia_fractal lathe looks_like merge mesh mesh2 object ovus parametric plane poly polygon " \
  "polynomial prism quadric quartic smooth_triangle sor sphere sphere_sweep superellipsoid text torus "   \
  "triangle union"

// Groups of places; what a page of help calls them is their name in words.
constexpr Group kGroups[] = {
    {"@object",
     "scene value union intersection difference merge composite object light_group looks_like projected_through "
     "bounded_by clipped_by mesh_camera object_pattern"},
    {"@modifier", VERISIM_OBJECT_BLOCKS},
    {"@transform", VERISIM_OBJECT_BLOCKS
     " light_source light_group component material camera fog sky_sphere media transform pigment normal texture "
     "density"},
    {"@pattern", "pigment normal texture density"},
    {"@modified", "pigment normal texture density"},
    {"@mapped", "pigment density"},
    {"@image", "image_map bump_map material_map image_pattern height_field"},
    {"@texel", "image_map bump_map material_map image_pattern"},
};
#undef VERISIM_OBJECT_BLOCKS

template <class Visit>
void each_word(std::string_view list, Visit&& visit) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    if (end) visit(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
}

std::string_view group_named(std::string_view name) {
  for (const Group& group : kGroups)
    if (group.name == name) return group.places;
  return {};
}

// From each word to its uses.
const std::map<std::string_view, std::vector<const Keyword*>>& index() {
  static const auto* const kIndex = [] {
    auto* all = new std::map<std::string_view, std::vector<const Keyword*>>;
    for (const KeywordSection* section : kSections)
      for (const Keyword& keyword : section->keywords) (*all)[keyword.word].push_back(&keyword);
    return all;
  }();
  return *kIndex;
}

const std::array<KeywordSection, std::size(kSections)>& sections() {
  static const auto kAll = [] {
    std::array<KeywordSection, std::size(kSections)> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = *kSections[i];
    return all;
  }();
  return kAll;
}

}  // namespace

std::span<const KeywordSection> keyword_sections() { return sections(); }

std::vector<const Keyword*> keyword_uses(std::string_view word) {
  const auto found = index().find(word);
  return found == index().end() ? std::vector<const Keyword*>{} : found->second;
}

std::vector<std::string_view> places_of(const Keyword& keyword) {
  std::vector<std::string_view> places;
  each_word(keyword.places, [&](std::string_view place) {
    if (place.starts_with('@'))
      each_word(group_named(place), [&](std::string_view one) { places.push_back(one); });
    else
      places.push_back(place);
  });
  return places;
}

bool may_stand(const Keyword& keyword, std::string_view place) {
  const auto places = places_of(keyword);
  return std::find(places.begin(), places.end(), place) != places.end();
}

const std::vector<std::string_view>& all_places() {
  static const auto* const kPlaces = [] {
    auto* all = new std::vector<std::string_view>;
    for (const KeywordSection* section : kSections)
      for (const Keyword& keyword : section->keywords)
        for (const std::string_view place : places_of(keyword))
          if (!place.starts_with('+')) all->push_back(place);
    std::sort(all->begin(), all->end());
    all->erase(std::unique(all->begin(), all->end()), all->end());
    return all;
  }();
  return *kPlaces;
}

}  // namespace verisim::parser
