#include "tracer/textures/pigment.h"

#include <cstring>

#include "tracer/textures/image_lookup.h"

namespace verisim::textures {
namespace {

// Colours as four components at once and the fifth alone.
using Float4 = float __attribute__((vector_size(16)));
static_assert(sizeof(Color) == 5 * sizeof(float));
Float4 first_four(const Color& c) {
  Float4 v;
  std::memcpy(&v, &c.r, sizeof v);
  return v;
}
void set(Color& c, Float4 four, float fifth) {
  std::memcpy(&c.r, &four, sizeof four);
  c.t = fifth;
}
// lower + (upper - lower) * t
void blend(const Color& lower, const Color& upper, float t, Color& result) {
  const Float4 low = first_four(lower);
  set(result, low + (first_four(upper) - low) * t, lower.t + (upper.t - lower.t) * t);
}

void map_lookup(const CompiledPigment& c, double v, Color& color) {
  const MapPlace place = c.positions.find(v);
  if (place.single()) color = c.colors[place.upper];
  else blend(c.colors[place.lower], c.colors[place.upper], place.t, color);
}

bool child_map(const CompiledPigment& c, const PatternValue& at, const SurfacePoint* surface, Color& color) {
  const Vec3& p = at.point;
  const MapPlace place = c.positions.find(at.value);
  const bool upper_has_color = evaluate(*c.children[place.upper], p, surface, color);
  if (place.single()) return upper_has_color;
  Color lower;
  const bool lower_has_color = evaluate(*c.children[place.lower], p, surface, lower);
  blend(lower, color, place.t, color);
  return upper_has_color || lower_has_color;
}

bool average(const CompiledPigment& c, const Vec3& p, const SurfacePoint* surface, Color& color) {
  Color sum;
  bool has_color = false;
  for (std::size_t i = 0; i < c.children.size(); ++i) {
    Color each;
    has_color |= evaluate(*c.children[i], p, surface, each);
    const float weight = c.positions.position(i);
    set(sum, first_four(sum) + first_four(each) * weight, sum.t + each.t * weight);
  }
  color = sum * (1 / c.total_weight);
  return has_color;
}

bool image_color(const CompiledPigment& c, const Vec3& p, Color& color) {
  const ImageLookup& lookup = c.pattern->as<ImageLookup>();
  double u, v;
  if (!locate(lookup, p, u, v)) {
    color = Color(1, 1, 1, 0, 1);
    return false;
  }
  color = map_color(lookup, u, v);
  return true;
}

}  // namespace

bool evaluate(const CompiledPigment& c, const Vec3& p, const SurfacePoint* surface, Color& color) {
  using enum CompiledPigment::Source;
  if (c.source == plain) {
    color = c.color;
    return true;
  }
  if (c.source == uv_mapping) {
    const Vec3 uv = surface ? uv_point(*surface) : p;
    return evaluate(*c.children[0], uv, surface, color);
  }
  switch (c.source) {
    case color_map: map_lookup(c, value_of(*c.pattern, p, surface).value, color); return true;
    case pigment_map: return child_map(c, value_of(*c.pattern, p, surface), surface, color);
    case CompiledPigment::Source::average: return textures::average(c, warped(*c.pattern, p), surface, color);
    default: return image_color(c, warped(*c.pattern, p), color);
  }
}

scene::ColorMap built_in_map(const scene::Pattern& pattern) {
  using enum scene::PatternKind;
  const Color black(0, 0, 0), white(1, 1, 1), red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1), yellow(1, 1, 0), cyan(0, 1, 1), magenta(1, 0, 1);
  const auto list = [](std::initializer_list<Color> colors) {
    scene::ColorMap map;
    for (const Color& c : colors) map.push_back({static_cast<float>(map.size()), c});
    return map;
  };
  switch (pattern.kind) {
    case agate:
      return {{0, white}, {0.5f, {0.95f, 0.75f, 0.5f}}, {0.5f, {0.9f, 0.7f, 0.5f}}, {0.6f, {0.9f, 0.7f, 0.4f}}, {0.6f, {1, 0.7f, 0.4f}}, {1, {0.6f, 0.3f, 0}}};
    case bozo: return {{0.4f, white}, {0.4f, green}, {0.6f, green}, {0.6f, blue}, {0.8f, blue}, {0.8f, red}};
    case marble: return {{0, {0.9f, 0.8f, 0.8f}}, {0.9f, {0.9f, 0.08f, 0.08f}}, {0.9f, black}};
    case wood: return {{0.6f, {0.666f, 0.312f, 0.2f}}, {0.6f, {0.4f, 0.1333f, 0.066f}}};
    case radial: return {{0, cyan}, {0.333f, yellow}, {0.666f, magenta}, {1, cyan}};
    case mandel:
      if (const auto* f = std::get_if<scene::FractalParams>(&*pattern.params); f && f->exponent == 2)
        return {{0.001f, black}, {0.001f, cyan}, {0.012f, yellow}, {0.015f, magenta}, {0.1f, cyan}};
      break;
    case brick: return list({{0.5f, 0.5f, 0.5f}, {0.6f, 0.15f, 0.15f}});
    case checker:
    case object: return list({blue, green});
    case hexagon: return list({blue, green, red});
    case square: return list({red, green, blue, yellow});
    case triangular:
    case cubic: return list({red, green, blue, yellow, cyan, magenta});
    default: break;
  }
  return {{0, black}, {1, white}};
}

}  // namespace verisim::textures
