#include "parser/scene/textures/texture.h"

#include <algorithm>
#include <cstdint>

#include "parser/scene/common/common.h"
#include "parser/scene/textures/maps.h"
#include "parser/scene/common/nesting.h"
#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

using scene::PatternKind;
using scene::Texture;

namespace {

void require_plain(Parser& parser, const scene::TexturePtr& texture) {
  if (texture->patterned()) parser.error(Code::incompatible, "Cannot layer over a patterned texture.");
}

// A plain texture's transformation goes to the pigment and the normal of every layer.
void transform_plain(Texture& texture, const Transform& t) {
  for (scene::TextureLayer& layer : texture.layers) {
    auto pigment = std::make_shared<scene::Pigment>(*layer.pigment);
    pigment->pattern.prepend(t);
    layer.pigment = pigment;
    layer.normal = scene::transformed(layer.normal, t);
  }
}

bool at_pigment_identifier(Parser& parser) {
  const Value* value = parser.peek_value();
  return value && std::holds_alternative<scene::PigmentPtr>(*value);
}

bool parse_part(Parser& parser, scene::TextureLayer& layer, bool* replaced = nullptr) {
  switch (word_at(parser)) {
    case Word::pigment: {
      Block block(parser);
      if (replaced) *replaced = at_pigment_identifier(parser);
      layer.pigment = parse_pigment_body(parser, layer.pigment);
      block.close();
      return true;
    }
    case Word::normal:
      layer.normal = parse_normal(parser, layer.normal);
      return true;
    case Word::finish:
      layer.finish = parse_finish(parser, layer.finish);
      return true;
    default:
      return false;
  }
}

// Identifiers of pigments, normals and finishes, which may stand at the beginning of a texture: the last of a kind
// counts.
void read_part_identifiers(Parser& parser, scene::TextureLayer& layer) {
  for (;;) {
    if (const auto* pigment = parser.accept_value<scene::PigmentPtr>())
      layer.pigment = *pigment;
    else if (const auto* normal = parser.accept_value<scene::NormalPtr>())
      layer.normal = *normal;
    else if (const auto* finish = parser.accept_value<Shared<scene::Finish>>())
      layer.finish = **finish;
    else
      return;
  }
}

bool at_part_identifier(Parser& parser) {
  const Value* value = parser.peek_value();
  return value &&
         (std::holds_alternative<scene::PigmentPtr>(*value) || std::holds_alternative<scene::NormalPtr>(*value) ||
          std::holds_alternative<Shared<scene::Finish>>(*value));
}

void parse_plain_items(Parser& parser, Texture& texture) {
  for (;;) {
    Transform item;
    if (parse_part(parser, texture.layers.back())) continue;
    if (parser.version() >= 300 && parse_no_bump_scale(parser)) {
      for (scene::TextureLayer& layer : texture.layers) {
        if (!layer.normal) continue;
        auto normal = std::make_shared<scene::Normal>(*layer.normal);
        normal->no_bump_scale = true;
        layer.normal = normal;
      }
      texture.no_bump_scale = true;
      continue;
    }
    if (parse_transform_item(parser, item)) {
      transform_plain(texture, item);
      continue;
    }
    if (parser.version() < 300 && parse_old_item(parser, texture.layers.back())) continue;
    return;
  }
}

// tiles { texture A tile2 texture B }: a checker with B first (spec 05 11.1).
std::shared_ptr<Texture> parse_tiles(Parser& parser) {
  Block block(parser);
  scene::TexturePtr first, second;
  while (parser.at(Word::texture)) add_layers(parser, first, parse_texture(parser));
  parser.expect(Word::tile2);
  while (parser.at(Word::texture)) add_layers(parser, second, parse_texture(parser));
  block.close();
  auto texture = std::make_shared<Texture>();
  texture->pattern.kind = PatternKind::checker;
  texture->pattern.frequency = 0;
  auto map = std::make_shared<scene::BlendMap<scene::TexturePtr>>();
  map->push_back({0, second ? second : parser.default_texture()});
  map->push_back({1, first ? first : parser.default_texture()});
  texture->texture_map = map;
  return texture;
}

std::shared_ptr<Texture> parse_material_map(Parser& parser) {
  Block block(parser);
  auto texture = std::make_shared<Texture>();
  texture->pattern.kind = PatternKind::image_map;  // stands for material_map in a texture
  texture->pattern.frequency = 0;
  texture->pattern.params = parse_image(parser, ImageUse::material_map);
  auto map = std::make_shared<scene::BlendMap<scene::TexturePtr>>();
  while (parser.at(Word::texture)) {
    scene::TexturePtr entry;
    add_layers(parser, entry, parse_texture(parser));
    map->push_back({static_cast<float>(map->size()), entry});
  }
  if (map->empty()) parser.error_expected("texture");
  texture->texture_map = map;
  block.close();
  return texture;
}

void parse_patterned_items(Parser& parser, Texture& texture) {
  const PatternKind kind = texture.pattern.kind;
  const bool fixed = list_size(kind) > 0 || kind == PatternKind::image_map;
  for (;;) {
    if (parser.at(Word::texture_map)) {
      if (fixed) parser.error(Code::incompatible, "Cannot use texture_map with this pattern type.");
      texture.texture_map = parse_texture_map(parser, kind == PatternKind::average);
      continue;
    }
    if (parse_no_bump_scale(parser)) {
      texture.no_bump_scale = true;
      continue;
    }
    if (!parse_pattern_modifier(parser, texture.pattern, PatternOwner::texture)) break;
  }
  if (kind == PatternKind::average && !texture.texture_map) parser.error(Code::missing_item, "Average must have map.");
  if (!texture.texture_map) parser.error(Code::missing_item, "Patterned texture must have texture_map.");
  check_pattern(parser, texture.pattern);
}

scene::TexturePtr parse_patterned(Parser& parser) {
  std::shared_ptr<Texture> texture;
  if (parser.at(Word::tiles)) {
    texture = parse_tiles(parser);
  } else if (parser.at(Word::material_map)) {
    texture = parse_material_map(parser);
  } else {
    texture = std::make_shared<Texture>();
    const auto read_list = [&](int size) {
      texture->texture_map = parse_block_list<scene::TexturePtr>(
          parser, size, Word::texture, [&] { return parser.default_texture(); }, [&] { return parse_texture(parser); });
      if (texture->texture_map) return;
      auto map = std::make_shared<scene::BlendMap<scene::TexturePtr>>();
      for (int i = 0; i < size; ++i) map->push_back({static_cast<float>(i), parser.default_texture()});
      texture->texture_map = map;
    };
    if (!parse_pattern_type(parser, texture->pattern, PatternOwner::texture, read_list)) return nullptr;
  }
  parse_patterned_items(parser, *texture);
  check_nesting(parser, *texture);
  return texture;
}

scene::TexturePtr parse_uv_mapped(Parser& parser) {
  parser.next();
  auto texture = std::make_shared<Texture>();
  texture->pattern.kind = PatternKind::uv_mapping;
  auto map = std::make_shared<scene::BlendMap<scene::TexturePtr>>();
  map->push_back({0, parse_texture_body(parser)});
  texture->texture_map = map;
  check_nesting(parser, *texture);
  return texture;
}

}  // namespace

void add_layers(Parser& parser, scene::TexturePtr& texture, const scene::TexturePtr& added) {
  const std::size_t before = texture ? texture->layers.size() : 0;
  // Up to 3.1 all but the bottom layer transmit what they filter (old_layers.cpp).
  const std::size_t turned = parser.version() <= 310 ? std::max<std::size_t>(before, 1) : SIZE_MAX;
  if (!texture && (added->patterned() || added->layers.size() <= turned)) {
    texture = added;
    return;
  }
  if (texture) require_plain(parser, texture);
  if (added->patterned()) parser.error(Code::incompatible, "Cannot layer a patterned texture over another.");
  // A texture that nobody else holds grows in place: thousands of layers would otherwise be copied thousands of times.
  const bool own = texture.use_count() == 1;
  auto result =
      own ? std::const_pointer_cast<Texture>(texture) : std::make_shared<Texture>(texture ? *texture : *added);
  if (texture) result->layers.insert(result->layers.end(), added->layers.begin(), added->layers.end());
  for (std::size_t i = turned; i < result->layers.size(); ++i)
    result->layers[i].pigment = filter_to_transmit(result->layers[i].pigment);
  texture = result;
}

bool parse_texture_part(Parser& parser, scene::TexturePtr& texture, scene::Rare<Transform>* steps, bool* replaced) {
  const Word word = word_at(parser);
  if (word != Word::pigment && word != Word::normal && word != Word::finish) return false;
  const scene::TexturePtr start = texture ? texture : parser.default_texture();
  require_plain(parser, start);
  auto result = std::make_shared<Texture>(*start);
  if (word == Word::pigment && steps && *steps) {
    scene::PigmentPtr& pigment = result->layers.back().pigment;
    pigment = scene::moved(pigment, *steps);
    *steps = {};
  }
  parse_part(parser, result->layers.back(), replaced);
  texture = result;
  return true;
}

scene::TexturePtr parse_texture_body(Parser& parser, bool is_default) {
  const Parser::Depth depth(parser);
  if (parser.at(Word::uv_mapping) && parser.version() >= 300) return parse_uv_mapped(parser);
  if (const auto* value = parser.accept_value<scene::TexturePtr>()) {
    const scene::TexturePtr original = *value;
    if (parser.at('}') || parser.at(']')) return original;  // shared, so that it is compiled once
    auto texture = std::make_shared<Texture>(*original);
    if (!texture->patterned()) {
      read_part_identifiers(parser, texture->layers.back());
      parse_plain_items(parser, *texture);
      return texture;
    }
    for (Transform item;;) {
      if (parse_no_bump_scale(parser)) {
        texture->no_bump_scale = true;
      } else if (parse_transform_item(parser, item)) {
        texture->pattern.prepend(item);
      } else {
        return texture;
      }
    }
  }
  auto texture = std::make_shared<Texture>(*parser.default_texture());
  if (at_part_identifier(parser)) {
    read_part_identifiers(parser, texture->layers.back());
  } else if (parser.version() >= 300) {
    if (scene::TexturePtr patterned = parse_patterned(parser)) return patterned;
  } else if (parser.at(Word::tiles) || parser.at(Word::material_map)) {
    return parse_patterned(parser);
  }
  parse_plain_items(parser, *texture);
  // Between 1.5 and 3.0 a texture says what its pigment is, unless the default texture does.
  const bool lacks_pigment = texture->layers.back().pigment->pattern.kind == PatternKind::none;
  if (lacks_pigment && !is_default && parser.version() >= 150 && parser.version() < 300)
    parser.error_expected("pigment identifier");
  return texture;
}

scene::TexturePtr parse_texture(Parser& parser) {
  return in_block(parser, [&] { return parse_texture_body(parser); });
}

}  // namespace verisim::parser
