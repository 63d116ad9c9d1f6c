#include "cli/describe/object_names.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace verisim::cli {
namespace {

#define VERISIM_SHAPE(held, name) #name,
constexpr const char* kShapeNames[] = {VERISIM_SHAPES(VERISIM_SHAPE)};
#undef VERISIM_SHAPE

}  // namespace

const char* object_keyword(const scene::Object& object) {
  if (const auto* cone = object.as<scene::Cone>()) return cone->base_radius == cone->cap_radius ? "cylinder" : "cone";
  if (const auto* csg = object.as<scene::Csg>())
    return csg->difference                       ? "difference"
           : csg->kind == scene::CsgKind::union_ ? "union"
           : csg->kind == scene::CsgKind::merge  ? "merge"
                                                 : "intersection";
  return kShapeNames[object.shape.index()];
}

std::string object_name(const scene::Object& object) {
  const std::string keyword = object_keyword(object);
  if (!object.place.file || object.place.line <= 0) return keyword;
  return fmt::format("{} ({}:{})", keyword, *object.place.file, object.place.line);
}

std::string color_word(const Rgb& c) {
  // As displays show it: halfway to white is what looks so.
  const auto shown = [](float v) { return std::pow(std::clamp(v, 0.0f, 1.0f), 1 / 2.2f); };
  const float r = shown(c.r), g = shown(c.g), b = shown(c.b);
  const float most = std::max({r, g, b}), least = std::min({r, g, b}), chroma = most - least;
  constexpr float kBlack = 0.12f, kGrey = 0.12f, kDark = 0.55f, kWhite = 0.93f, kPale = 0.35f;
  if (most < kBlack) return "black";
  if (chroma < kGrey * most) return most > kWhite ? "white" : most < kDark ? "dark grey" : "grey";
  float hue = most == r ? (g - b) / chroma : most == g ? 2 + (b - r) / chroma : 4 + (r - g) / chroma;  // 0 .. 6
  if (hue < 0) hue += 6;
  struct Hue {
    float end;
    const char* name;
  };
  constexpr Hue kHues[] = {{0.3f, "red"},  {0.75f, "orange"}, {1.25f, "yellow"}, {2.6f, "green"}, {3.4f, "cyan"},
                           {4.4f, "blue"}, {4.8f, "violet"},  {5.4f, "magenta"}, {5.75f, "pink"}, {6.1f, "red"}};
  const char* name = std::find_if(std::begin(kHues), std::end(kHues), [&](const Hue& h) { return hue < h.end; })->name;
  return fmt::format("{}{}", most < kDark ? "dark " : chroma < kPale * most ? "pale " : "", name);
}

std::string placed_object_name(const scene::Object& object, const parser::Origins& origins) {
  const parser::Origins::Origin origin = origins.of(object.place);
  std::string name = object_keyword(object);
  if (!origin.declared.empty()) name += fmt::format(" '{}'", origin.declared);
  if (!object.place.file || object.place.line <= 0) return name;
  name += fmt::format(" ({}:{}", *object.place.file, object.place.line);
  const std::string here = *object.place.file + ":";
  for (const std::string& call : origin.calls)
    name += ", from " + (call.starts_with(here) ? "line " + call.substr(here.size()) : call);
  return name + ")";
}

std::string full_object_name(const scene::Object& object, const parser::Origins& origins) {
  std::string color;
  if (const scene::TexturePtr& texture = object.texture; texture && texture->layers.size() == 1) {
    const scene::Pigment& pigment = *texture->layers[0].pigment;
    if (pigment.pattern.kind == scene::PatternKind::plain && pigment.color.f + pigment.color.t < 0.5f)
      color = color_word(pigment.color.rgb()) + " ";
  }
  return color + placed_object_name(object, origins);
}

}  // namespace verisim::cli
