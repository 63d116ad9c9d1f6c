// color_map, pigment_map, normal_map, slope_map, texture_map, density_map (spec 05 section 4).
#pragma once

#include "parser/language/blocks.h"
#include "parser/scene/common/nesting.h"
#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

// An error for patterns without maps (what has colours of its own, and lists) and for the kind `also`.
void check_takes_map(Parser& parser, scene::PatternKind kind, const char* map,
                     scene::PatternKind also = scene::PatternKind::none);

// Each with its keyword at the cursor; `weights` for the maps of an `average` pattern, whose numbers may be left out.
Shared<scene::ColorMap> parse_color_map(Parser& parser);
Shared<scene::BlendMap<scene::PigmentPtr>> parse_pigment_map(Parser& parser, bool weights);
Shared<scene::BlendMap<scene::NormalPtr>> parse_normal_map(Parser& parser, bool weights);
Shared<scene::BlendMap<scene::SlopeEntry>> parse_slope_map(Parser& parser);
Shared<scene::BlendMap<scene::TexturePtr>> parse_texture_map(Parser& parser, bool weights);
Shared<scene::BlendMap<scene::DensityPtr>> parse_density_map(Parser& parser, bool weights);

// Lists of checker, brick ...: colours that are not written come from the built-in list, which a later pattern takes as
// its map (spec 05 4.3).
Shared<scene::ColorMap> parse_color_list(Parser& parser, scene::PatternKind kind);

// Up to `size` blocks that start with `word`; missing ones are what `absent` is behind them, where `#default` may have
// changed it. Null: none was written.
template <class T, class Absent, class Read>
Shared<scene::BlendMap<T>> parse_block_list(Parser& parser, int size, Word word, const Absent& absent,
                                            const Read& read) {
  if (!parser.at(word)) return nullptr;
  auto map = std::make_shared<scene::BlendMap<T>>();
  for (int i = 0; i < size && parser.at(word); ++i) {
    map->push_back({static_cast<float>(i), read()});
    parser.optional_comma();
  }
  while (map->size() < static_cast<std::size_t>(size)) map->push_back({static_cast<float>(map->size()), absent()});
  return map;
}

// The end of the body of a pigment, normal or density: what can only be checked when all of it is known.
template <class T>
void check_body(Parser& parser, const T& body, bool has_map_of_its_kind) {
  if (body.pattern.kind == scene::PatternKind::average && !has_map_of_its_kind)
    parser.error(Code::missing_item, "Average must have map.");
  check_pattern(parser, body.pattern);
  check_nesting(parser, body);
}

}  // namespace verisim::parser
