// density { ... } of media (spec 05 section 4, 07 section 4).
#include "parser/scene/common/common.h"
#include "parser/scene/textures/maps.h"
#include "parser/scene/common/nesting.h"
#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

using scene::Density;
using scene::PatternKind;

namespace {

scene::DensityPtr plain_white() {
  auto density = std::make_shared<Density>();
  density->pattern.kind = PatternKind::plain;
  return density;
}

// Without a type it takes maps, which mean nothing.
scene::DensityPtr untyped() {
  auto density = std::make_shared<Density>();
  density->color = {0, 0, 0};
  return density;
}

void read_list(Parser& parser, Density& density, int size) {
  density.density_map = parse_block_list<scene::DensityPtr>(parser, size, Word::density, plain_white,
                                                            [&] { return parse_density(parser); });
  density.color_map = density.density_map ? nullptr : parse_color_list(parser, density.pattern.kind);
}

void read_uv_mapped(Parser& parser, Density& density) {
  parser.next();
  density.pattern.kind = PatternKind::uv_mapping;
  auto map = std::make_shared<scene::BlendMap<scene::DensityPtr>>();
  map->push_back({0, parse_density_body(parser)});
  density.density_map = map;
}

bool parse_type(Parser& parser, Density& density) {
  if (at_color(parser)) {
    density.pattern.kind = PatternKind::plain;
    density.color = parser.parse_color();
    return true;
  }
  return parse_pattern_type(parser, density.pattern, PatternOwner::density,
                            [&](int size) { read_list(parser, density, size); });
}

bool parse_modifier(Parser& parser, Density& density) {
  switch (word_at(parser)) {
    case Word::color_map:
      check_takes_map(parser, density.pattern.kind, "color_map", PatternKind::average);
      density.color_map = parse_color_map(parser);
      density.density_map = nullptr;
      return true;
    case Word::density_map:
      check_takes_map(parser, density.pattern.kind, "density_map");
      density.density_map = parse_density_map(parser, density.pattern.kind == PatternKind::average);
      density.color_map = nullptr;
      return true;
    default:
      return parse_pattern_modifier(parser, density.pattern, PatternOwner::density);
  }
}

}  // namespace

scene::DensityPtr parse_density_body(Parser& parser) {
  const Parser::Depth depth(parser);
  scene::DensityPtr original = untyped();
  if (const auto* value = parser.accept_value<scene::DensityPtr>()) original = *value;
  auto density = std::make_shared<Density>(*original);
  if (parser.at(Word::uv_mapping)) {
    read_uv_mapped(parser, *density);
    check_nesting(parser, *density);
    return density;
  }
  bool changed = parse_type(parser, *density);
  while (parse_modifier(parser, *density)) changed = true;
  if (!changed) return original;
  check_body(parser, *density, static_cast<bool>(density->density_map));
  return density;
}

scene::DensityPtr parse_density(Parser& parser) {
  return in_block(parser, [&] { return parse_density_body(parser); });
}

}  // namespace verisim::parser
