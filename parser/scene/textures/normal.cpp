// normal { ... } (spec 05 section 10).
#include <fmt/format.h>

#include "parser/scene/common/common.h"
#include "parser/scene/textures/maps.h"
#include "parser/scene/common/nesting.h"
#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

using scene::Normal;
using scene::PatternKind;

namespace {

void read_list(Parser& parser, Normal& normal, int size) {
  const auto absent = [&]() -> scene::NormalPtr {
    if (default_layer(parser).normal) return default_layer(parser).normal;
    return std::make_shared<Normal>();
  };
  normal.normal_map = parse_block_list<scene::NormalPtr>(
      parser, size, Word::normal, absent, [&] { return parse_normal(parser, default_layer(parser).normal); });
  normal.slope_map = nullptr;                       // also where nothing is listed (spec 05 10.4)
  if (!normal.normal_map) normal.accuracy = 0.02f;  // a height pattern then (spec 05 10.3)
}

void read_uv_mapped(Parser& parser, Normal& normal) {
  parser.next();
  normal.pattern.kind = PatternKind::uv_mapping;
  auto map = std::make_shared<scene::BlendMap<scene::NormalPtr>>();
  map->push_back({0, parse_normal_body(parser, default_layer(parser).normal)});
  normal.normal_map = map;
}

void refuse_with_image(Parser& parser, const Normal& normal, const char* map) {
  if (normal.pattern.kind == PatternKind::bump_map)
    parser.error(Code::incompatible, fmt::format("Keyword '{}' cannot be used with this normal type.", map));
}

bool parse_modifier(Parser& parser, Normal& normal) {
  switch (word_at(parser)) {
    case Word::bump_size:
      parser.next();
      normal.amount = to_float(parser.parse_float());
      return true;
    case Word::accuracy:
      parser.next();
      normal.accuracy = to_float(parser.parse_float());
      return true;
    case Word::no_bump_scale:
      normal.no_bump_scale = parse_no_bump_scale(parser);
      return true;
    case Word::slope_map:
      refuse_with_image(parser, normal, "slope_map");
      check_takes_map(parser, normal.pattern.kind, "slope_map", PatternKind::average);
      normal.slope_map = parse_slope_map(parser);
      normal.normal_map = nullptr;
      return true;
    case Word::normal_map:
      refuse_with_image(parser, normal, "normal_map");
      check_takes_map(parser, normal.pattern.kind, "normal_map", PatternKind::facets);
      normal.normal_map = parse_normal_map(parser, normal.pattern.kind == PatternKind::average);
      normal.slope_map = nullptr;
      return true;
    default:
      return parse_pattern_modifier(parser, normal.pattern, PatternOwner::normal);
  }
}

}  // namespace

bool parse_normal_type(Parser& parser, Normal& normal) {
  if (parser.at(Word::bump_map)) {
    parser.next();
    parser.expect('{');
    normal.pattern.kind = PatternKind::bump_map;
    normal.pattern.frequency = 0;
    normal.pattern.params = parse_image(parser, ImageUse::bump_map, &normal.amount);
    close_block(parser);
    return true;
  }
  return parse_pattern_type(parser, normal.pattern, PatternOwner::normal,
                            [&](int size) { read_list(parser, normal, size); });
}

scene::NormalPtr parse_normal_body(Parser& parser, const scene::NormalPtr& start) {
  const Parser::Depth depth(parser);
  scene::NormalPtr original = start;
  if (const auto* value = parser.accept_value<scene::NormalPtr>()) original = *value;
  auto normal = original ? std::make_shared<Normal>(*original) : std::make_shared<Normal>();
  if (parser.at(Word::uv_mapping)) {
    read_uv_mapped(parser, *normal);
    check_nesting(parser, *normal);
    return normal;
  }
  bool changed = parse_normal_type(parser, *normal);
  if (((changed || original != start) && parser.accept(',')) || parser.at_number_start()) {
    normal->amount = to_float(parser.parse_float());
    changed = true;
  }
  while (parse_modifier(parser, *normal)) changed = true;
  if (!changed) return original ? original : normal;
  check_body(parser, *normal, static_cast<bool>(normal->normal_map));
  return normal;
}

scene::NormalPtr parse_normal(Parser& parser, const scene::NormalPtr& start) {
  return in_block(parser, [&] { return parse_normal_body(parser, start); });
}

scene::NormalPtr parse_normal(Parser& parser) { return parse_normal(parser, default_layer(parser).normal); }

bool parse_no_bump_scale(Parser& parser) {
  if (!parser.at(Word::no_bump_scale)) return false;
  parser.next();
  parser.scene().settings.no_bump_scale = true;
  return true;
}

}  // namespace verisim::parser
