#include "parser/scene/textures/maps.h"

#include <fmt/format.h>

#include "parser/scene/common/common.h"
#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

namespace {

constexpr std::size_t kMaxEntries = 256;

// `MAP { IDENTIFIER }` or `MAP { [position body] ... }`; read_entry reads the body and appends to the map.
template <class Holder, class Map, class ReadEntry>
std::shared_ptr<const Map> parse_map(Parser& parser, std::string_view name, bool weights, const ReadEntry& read_entry) {
  Block block(parser);
  if (const auto* value = parser.accept_value<Holder>()) {
    auto shared = value->map;
    block.close();
    return shared;
  }
  auto map = std::make_shared<Map>();
  while (parser.accept('[')) {
    float position = 1;
    if (!weights || parser.at_number_start()) {
      position = to_float(parser.parse_float());
      parser.optional_comma();
    }
    read_entry(*map, position);
    if (!parser.accept(']')) parser.error_expected("]");
    if (map->size() > kMaxEntries)
      parser.error(Code::too_many, "Too many entries in map. The maximum is 256 entries per map.");
  }
  if (map->empty()) parser.error(Code::too_few, "Must have at least one entry in " + std::string(name) + ".");
  block.close();
  return map;
}

Color to_color(const Numeric& n) {
  return {to_float(n.v[0]), to_float(n.v[1]), to_float(n.v[2]), to_float(n.v[3]), to_float(n.v[4])};
}

// `[p color]`, or the old `[a, b color C1 color C2]`.
void read_color_entry(Parser& parser, scene::ColorMap& map, float position) {
  if (at_color(parser)) {
    map.push_back({position, parser.parse_color()});
    return;
  }
  if (parser.at('<')) parser.error_expected("color");
  if (parser.at('+') || parser.at('-')) parser.error_expected("color");
  const Numeric value = parser.parse_full_numeric();  // 0.3*White is a colour, too
  if (value.terms > 1) {
    if (value.terms != 5) parser.error_expected("color");
    map.push_back({position, to_color(value)});
    return;
  }
  parser.optional_comma();
  if (!at_color(parser) && !parser.at_number_start()) parser.error_expected("color");
  const Color first = parser.parse_color();
  if (!parser.at(Word::color)) parser.error_expected("color");
  map.push_back({position, first});
  map.push_back({to_float(value.v[0]), parser.parse_color()});
}

}  // namespace

void check_takes_map(Parser& parser, scene::PatternKind kind, const char* map, scene::PatternKind also) {
  const bool none = kind == scene::PatternKind::plain || kind == scene::PatternKind::image_map || list_size(kind) > 0;
  if (none || (also != scene::PatternKind::none && kind == also))
    parser.error(Code::incompatible, fmt::format("Cannot use {} with this pattern type.", map));
}

Shared<scene::ColorMap> parse_color_map(Parser& parser) {
  return parse_map<ColorMapValue, scene::ColorMap>(
      parser, "color_map", false, [&](scene::ColorMap& map, float p) { read_color_entry(parser, map, p); });
}

Shared<scene::BlendMap<scene::PigmentPtr>> parse_pigment_map(Parser& parser, bool weights) {
  return parse_map<PigmentMapValue, scene::BlendMap<scene::PigmentPtr>>(
      parser, "pigment_map", weights, [&](auto& map, float p) {
        map.push_back({p, parse_pigment_body(parser, default_layer(parser).pigment)});
      });
}

Shared<scene::BlendMap<scene::NormalPtr>> parse_normal_map(Parser& parser, bool weights) {
  return parse_map<NormalMapValue, scene::BlendMap<scene::NormalPtr>>(
      parser, "normal_map", weights, [&](auto& map, float p) {
        map.push_back({p, parse_normal_body(parser, default_layer(parser).normal)});
      });
}

Shared<scene::BlendMap<scene::SlopeEntry>> parse_slope_map(Parser& parser) {
  return parse_map<SlopeMap, scene::BlendMap<scene::SlopeEntry>>(parser, "slope_map", false, [&](auto& map, float p) {
    const Vec2 v = parser.parse_vec2();
    map.push_back({p, {v.x, v.y}});
  });
}

Shared<scene::BlendMap<scene::TexturePtr>> parse_texture_map(Parser& parser, bool weights) {
  return parse_map<TextureMapValue, scene::BlendMap<scene::TexturePtr>>(
      parser, "texture_map", weights, [&](auto& map, float p) {
        map.push_back({p, parse_texture_body(parser)});
      });
}

Shared<scene::BlendMap<scene::DensityPtr>> parse_density_map(Parser& parser, bool weights) {
  return parse_map<DensityMapValue, scene::BlendMap<scene::DensityPtr>>(
      parser, "density_map", weights, [&](auto& map, float p) {
        map.push_back({p, parse_density_body(parser)});
      });
}

Shared<scene::ColorMap> parse_color_list(Parser& parser, scene::PatternKind kind) {
  auto map = std::make_shared<scene::ColorMap>();
  bool written = true;
  for (const Color& built_in : scene::built_in_list(kind)) {
    written = written && (at_color(parser) || parser.at_number_start());
    map->push_back({static_cast<float>(map->size()), written ? parser.parse_color() : built_in});
    if (written) parser.optional_comma();
  }
  return map;
}

}  // namespace verisim::parser
