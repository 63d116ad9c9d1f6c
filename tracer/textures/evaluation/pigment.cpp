#include "tracer/textures/evaluation/pigment.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "tracer/textures/lookup/image_lookup.h"

namespace verisim::textures {
namespace {

// The last of the positions that rise from the first one and have its colour, if it is below all that follow.
double end_of_first_color(const ColorTable& c) {
  double end = 0;
  for (std::size_t i = 0; i + 1 < c.colors.size() && c.colors[i] == c.colors[0] && c.positions.position(i) >= end; ++i)
    end = c.positions.position(i);
  return end < c.positions.position(c.colors.size() - 1) ? end : 0;
}

// From the entry before to entry i.
ColorSegment segment(const ColorTable& c, std::size_t i) {
  ColorSegment s;
  const float position = c.positions.position(i);
  s.position = position;
  if (i == 0) return s;
  const float low = c.positions.position(i - 1), width = position - low;
  s.low = low;
  s.width = width;
  const Color lower = c.colors[i - 1], rise = c.colors[i] - lower;
  std::memcpy(s.lower, &lower, sizeof lower);
  std::memcpy(s.rise, &rise, sizeof rise);
  s.constant = rise == Color(0, 0, 0);
  return s;
}

}  // namespace

ColorTable::ColorTable(MapPositions p, std::vector<Color> c) : positions(std::move(p)), colors(std::move(c)) {
  flat = end_of_first_color(*this);
  if (colors.size() > kFew + 1) return;
  segments.reserve(colors.size());
  first_maxima = std::make_unique<Maxima>();
  std::fill(std::begin(first_maxima->of), std::end(first_maxima->of), std::numeric_limits<double>::infinity());
  double maximum = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < colors.size(); ++i) {
    segments.push_back(segment(*this, i));
    maximum = i == 0 ? segments[0].position : std::max(maximum, segments[i].position);
    if (i + 1 < colors.size()) first_maxima->of[i] = maximum;
  }
}

bool ColorTable::same_everywhere() const {
  return std::all_of(colors.begin(), colors.end(), [this](const Color& color) { return color == colors[0]; });
}
bool ColorTable::transparent() const { return std::any_of(colors.begin(), colors.end(), lets_light_through); }

bool lets_light_through(const Color& c) { return std::fabs(c.f) > kEpsilon || std::fabs(c.t) > kEpsilon; }

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

scene::ColorMap built_in_map(const scene::Pattern& pattern) {
  using enum scene::PatternKind;
  const Color black(0, 0, 0), white(1, 1, 1), red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1), yellow(1, 1, 0),
      cyan(0, 1, 1), magenta(1, 0, 1);
  if (const auto list = scene::built_in_list(pattern.kind); !list.empty()) {
    scene::ColorMap map;
    for (const Color& c : list) map.push_back({static_cast<float>(map.size()), c});
    return map;
  }
  switch (pattern.kind) {
    case agate:
      return {{0, white},
              {0.5f, {0.95f, 0.75f, 0.5f}},
              {0.5f, {0.9f, 0.7f, 0.5f}},
              {0.6f, {0.9f, 0.7f, 0.4f}},
              {0.6f, {1, 0.7f, 0.4f}},
              {1, {0.6f, 0.3f, 0}}};
    case bozo:
      return {{0.4f, white}, {0.4f, green}, {0.6f, green}, {0.6f, blue}, {0.8f, blue}, {0.8f, red}};
    case marble:
      return {{0, {0.9f, 0.8f, 0.8f}}, {0.9f, {0.9f, 0.08f, 0.08f}}, {0.9f, black}};
    case wood:
      return {{0.6f, {0.666f, 0.312f, 0.2f}}, {0.6f, {0.4f, 0.1333f, 0.066f}}};
    case radial:
      return {{0, cyan}, {0.333f, yellow}, {0.666f, magenta}, {1, cyan}};
    case mandel:
      if (const auto* f = std::get_if<scene::FractalParams>(&*pattern.params); f && f->exponent == 2)
        return {{0.001f, black}, {0.001f, cyan}, {0.012f, yellow}, {0.015f, magenta}, {0.1f, cyan}};
      break;
    default:
      break;
  }
  return {{0, black}, {1, white}};
}

}  // namespace verisim::textures
