// pigment { ... } (spec 05 sections 2 and 4).
#include "parser/scene/common/common.h"
#include "parser/scene/textures/maps.h"
#include "parser/scene/common/nesting.h"
#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

using scene::PatternKind;
using scene::Pigment;

namespace {

void read_list(Parser& parser, Pigment& pigment, int size) {
  const auto absent = [&] { return default_layer(parser).pigment; };
  pigment.pigment_map = parse_block_list<scene::PigmentPtr>(parser, size, Word::pigment, absent,
                                                            [&] { return parse_pigment(parser, absent()); });
  pigment.color_map = pigment.pigment_map ? nullptr : parse_color_list(parser, pigment.pattern.kind);
}

// The rest of the statement becomes a pigment of its own, evaluated at (u, v, 0) (spec 05 11.3).
void read_uv_mapped(Parser& parser, Pigment& pigment) {
  parser.next();
  pigment.pattern.kind = PatternKind::uv_mapping;
  auto map = std::make_shared<scene::BlendMap<scene::PigmentPtr>>();
  map->push_back({0, parse_pigment_body(parser, default_layer(parser).pigment)});
  pigment.pigment_map = map;
  pigment.color_map = nullptr;
}

bool parse_modifier(Parser& parser, Pigment& pigment) {
  switch (word_at(parser)) {
    case Word::color_map:
      check_takes_map(parser, pigment.pattern.kind, "color_map", PatternKind::average);
      pigment.color_map = parse_color_map(parser);
      pigment.pigment_map = nullptr;
      return true;
    case Word::pigment_map:
      check_takes_map(parser, pigment.pattern.kind, "pigment_map");
      pigment.pigment_map = parse_pigment_map(parser, pigment.pattern.kind == PatternKind::average);
      pigment.color_map = nullptr;
      return true;
    case Word::quick_color:
      parser.next();
      pigment.quick_color = parser.parse_color();
      return true;
    default:
      return parse_pattern_modifier(parser, pigment.pattern, PatternOwner::pigment);
  }
}

}  // namespace

bool parse_pigment_type(Parser& parser, Pigment& pigment) {
  if (at_color(parser)) {
    pigment.pattern.kind = PatternKind::plain;
    pigment.color = parser.parse_color();
    return true;
  }
  if (!parse_pattern_type(parser, pigment.pattern, PatternOwner::pigment,
                          [&](int size) { read_list(parser, pigment, size); }))
    return false;
  if (const auto* image = pigment.pattern.params ? std::get_if<scene::ImageParams>(&*pigment.pattern.params) : nullptr)
    pigment.image_filters |= image->filters;
  return true;
}

scene::TextureLayer default_layer(Parser& parser) { return parser.default_texture()->layers.front(); }

const scene::PigmentPtr& blank_pigment() {
  static const scene::PigmentPtr blank = std::make_shared<const Pigment>();
  return blank;
}

scene::PigmentPtr parse_pigment_body(Parser& parser, const scene::PigmentPtr& start) {
  const Parser::Depth depth(parser);
  std::shared_ptr<Pigment> pigment;
  bool changed = false;
  scene::PigmentPtr original = start;
  if (const auto* value = parser.accept_value<scene::PigmentPtr>()) original = *value;
  pigment = std::make_shared<Pigment>(*original);
  if (parser.at(Word::uv_mapping)) {
    read_uv_mapped(parser, *pigment);
    check_nesting(parser, *pigment);
    return pigment;
  }
  changed = parse_pigment_type(parser, *pigment);
  if (!changed && pigment->pattern.kind == PatternKind::none)
    parser.warning(Code::missing_item, "Pigment type unspecified or not 1st item.");
  while (parse_modifier(parser, *pigment)) changed = true;
  if (!changed) return original;  // shared, so that equal pigments are compiled once
  check_body(parser, *pigment, static_cast<bool>(pigment->pigment_map));
  return pigment;
}

scene::PigmentPtr parse_pigment(Parser& parser, const scene::PigmentPtr& start) {
  return in_block(parser, [&] { return parse_pigment_body(parser, start); });
}

scene::PigmentPtr parse_pigment(Parser& parser) { return parse_pigment(parser, default_layer(parser).pigment); }
scene::PigmentPtr parse_independent_pigment(Parser& parser) { return parse_pigment(parser, blank_pigment()); }

scene::Pattern parse_pattern_body(Parser& parser) {
  scene::Pattern pattern;
  if (!parse_pattern_type(parser, pattern, PatternOwner::function, [](int) {})) parser.error_expected("pattern type");
  while (parse_pattern_modifier(parser, pattern, PatternOwner::function)) {
  }
  check_pattern(parser, pattern);
  close_block(parser);
  return pattern;
}

}  // namespace verisim::parser
