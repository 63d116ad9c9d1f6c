// Everything that may follow the parameters of an object (spec 03 section 6).
#include "parser/scene/global_settings.h"
#include "parser/scene/interior.h"
#include "parser/scene/objects.h"
#include "parser/scene/textures/texture.h"
#include "parser/scene/common/transform.h"
#include "tracer/scene/solid_parts.h"
#include "tracer/textures/compile/texture_pool.h"

namespace verisim::parser {

using scene::Flag;
using scene::Object;

namespace {

// hollow reaches the children that say nothing themselves at once (spec 03 5.4).
void inherit_hollow(Object& object, bool hollow) {
  for (const scene::ObjectPtr& child : scene::own_children(object)) {
    auto& writable = const_cast<Object&>(*child);
    if (writable.hollow != Flag::unset) continue;
    writable.hollow_inherited = hollow;
    inherit_hollow(writable, hollow);
  }
}

void set_double_illuminate(Object& object, bool on) {
  object.double_illuminate = on;
  for (const scene::ObjectPtr& child : scene::own_children(object))
    set_double_illuminate(const_cast<Object&>(*child), on);
}

bool may_be_sturm(const scene::Shape& shape) {
  return std::holds_alternative<scene::Poly>(shape) || std::holds_alternative<scene::Torus>(shape) ||
         std::holds_alternative<scene::Ovus>(shape) ||
         std::holds_alternative<std::shared_ptr<const scene::Blob>>(shape) ||
         std::holds_alternative<std::shared_ptr<const scene::Lathe>>(shape) ||
         std::holds_alternative<std::shared_ptr<const scene::Sor>>(shape) ||
         std::holds_alternative<std::shared_ptr<const scene::Prism>>(shape);
}

bool has_hierarchy(const scene::Shape& shape) {
  return std::holds_alternative<std::shared_ptr<const scene::Blob>>(shape) ||
         std::holds_alternative<std::shared_ptr<const scene::HeightField>>(shape) ||
         std::holds_alternative<scene::Mesh>(shape);
}

[[noreturn]] void error_with_object(Parser& parser, Word word) {
  parser.error(Code::misplaced_keyword,
               "Keyword '" + std::string(spelling(word)) + "' cannot be used with this object.");
}

void parse_split_union(Parser& parser, Object& object) {
  parser.next();
  object.split_union = parser.parse_float() > 0;
  const auto* csg = object.as<scene::Csg>();
  const bool text = object.as<std::shared_ptr<const scene::Text>>();  // the union of its letters
  if (!text && (!csg || csg->kind == scene::CsgKind::intersection))
    parser.error(Code::misplaced_keyword, "split_union found in non-union object.");
}

void parse_radiosity(Parser& parser, Object& object) {
  parser.next();
  parser.expect('{');
  while (parser.accept(Word::importance)) {
    object.radiosity_importance = to_float(parser.parse_float());
    if (!(object.radiosity_importance > 0 && object.radiosity_importance <= 1))
      parser.error(Code::bad_value, "Radiosity importance must be greater than 0 and not larger than 1.");
  }
  close_block(parser);
}

void parse_object_material(Parser& parser, Object& object) {
  Material material =
      parse_material(parser, {object.texture, object.interior_texture, object.interior, object.solid_steps});
  object.solid_steps = std::move(material.solid_steps);
  object.texture = std::move(material.texture);
  object.interior_texture = std::move(material.interior_texture);
  object.interior = material.interior ? std::make_shared<scene::Interior>(*material.interior) : nullptr;
}

bool has_own_textures(const Object& object) {
  const auto* mesh = object.as<scene::Mesh>();
  return mesh && !mesh->data->textures.empty();
}

// From now on shadow rays go by the texture that the blob has.
void forget_first_texture(Object& object, const scene::Blob& blob) {
  auto forgetful = std::make_shared<scene::Blob>(blob);
  forgetful->first_texture = nullptr;
  object.shape = std::shared_ptr<const scene::Blob>(std::move(forgetful));
}

bool parse_part_of_texture(Parser& parser, Object& object) {
  bool replaced = false;
  if (!parse_texture_part(parser, object.texture, &object.solid_steps, &replaced)) return false;
  const auto* blob = object.as<std::shared_ptr<const scene::Blob>>();
  const scene::TexturePtr first = blob ? (*blob)->first_texture : nullptr;
  if (replaced && first && first->layers.size() == object.texture->layers.size()) forget_first_texture(object, **blob);
  return true;
}

// What it is covered with and filled with. False: none of that.
bool parse_appearance(Parser& parser, Object& object) {
  const Word word = word_at(parser);
  switch (word) {
    case Word::texture:
    case Word::pigment:
    case Word::normal:
    case Word::finish:
    case Word::interior_texture:
    case Word::material:
      object.texture_forgotten = false;
      break;
    default:
      break;
  }
  switch (word) {
    case Word::texture:
      add_layers(parser, object.texture, parse_texture(parser));
      object.solid_steps = {};
      return true;
    case Word::pigment:
    case Word::normal:
    case Word::finish:
      return parse_part_of_texture(parser, object);
    case Word::interior_texture:
      add_layers(parser, object.interior_texture, parse_texture(parser));
      return true;
    case Word::interior:
      object.interior = parse_interior(parser, object.interior);
      return true;
    case Word::material:
      parse_object_material(parser, object);
      return true;
    case Word::uv_mapping:
      parser.next();
      if (object.texture) parser.error(Code::incompatible, "uv_mapping must be specified before texture.");
      object.uv_mapping = true;
      return true;
    default:
      return false;
  }
}

// It can, if there are solids in it, but POV-Ray says so.
bool cannot_be_inverted(const Object& object) {
  return scene::is_patch(object) || (object.as<scene::Csg>() && !scene::has_only_solid_parts(object));
}

// What rays make of it. False: none of that.
bool parse_object_flag(Parser& parser, Object& object) {
  const Word word = word_at(parser);
  const auto flag = [&](bool& target) {
    parser.next();
    target = parser.parse_flag();
    return true;
  };
  switch (word) {
    case Word::inverse:
      parser.next();
      if (cannot_be_inverted(object)) parser.warning(Code::incompatible, "Cannot invert a patch object.");
      scene::invert(object);
      return true;
    case Word::sturm:
      if (!may_be_sturm(object.shape)) error_with_object(parser, word);
      return flag(object.sturm);
    case Word::hierarchy:
      if (!has_hierarchy(object.shape)) error_with_object(parser, word);
      return flag(object.hierarchy);
    case Word::hollow: {
      parser.next();
      const bool hollow = parser.parse_flag();
      object.hollow = hollow ? Flag::on : Flag::off;
      inherit_hollow(object, hollow);
      return true;
    }
    case Word::double_illuminate:
      parser.next();
      set_double_illuminate(object, parser.parse_flag());
      return true;
    case Word::no_shadow:
      parser.next();
      object.no_shadow = true;
      return true;
    case Word::no_image:
      return flag(object.no_image);
    case Word::no_reflection:
      return flag(object.no_reflection);
    case Word::no_radiosity:
      return flag(object.no_radiosity);
    case Word::dtag:
      parser.next();
      parser.parse_string();
      return true;
    default:
      return false;
  }
}

bool parse_modifier(Parser& parser, Object& object) {
  if (parse_appearance(parser, object) || parse_object_flag(parser, object)) return true;
  switch (word_at(parser)) {
    case Word::translate:
    case Word::rotate:
    case Word::scale:
    case Word::matrix:
    case Word::transform:
      return parse_object_transform(parser, object);
    case Word::photons:
      parse_object_photons(parser, object);
      return true;
    case Word::radiosity:
      parse_radiosity(parser, object);
      return true;
    case Word::cutaway_textures: {
      const auto* csg = object.as<scene::Csg>();
      if (!csg || csg->kind != scene::CsgKind::intersection)
        parser.error(Code::misplaced_keyword, "cutaway_textures can only be used with intersection and difference.");
      parser.next();
      object.cutaway_textures = true;
      return true;
    }
    case Word::split_union:
      parse_split_union(parser, object);
      return true;
    case Word::bounded_by:
      parse_bounded_by(parser, object);
      return true;
    case Word::clipped_by:
      parse_clipped_by(parser, object);
      return true;
    default:
      break;
  }
  if (at_color(parser)) {
    parser.parse_color();
    if (parser.version() >= 150) parser.warning(Code::no_effect, "Quick color belongs in texture. Color ignored.");
    return true;
  }
  return false;
}

}  // namespace

void parse_object_modifiers(Parser& parser, Object& object) {
  while (parse_modifier(parser, object)) {
  }
  close_block(parser);
  if (object.interior_texture && !object.texture && !has_own_textures(object))
    parser.error(Code::missing_item, "Interior texture requires an exterior texture.");
  object.texture = parser.texture_pool().one(std::move(object.texture));
  scene::finish_modifiers(object);
}

}  // namespace verisim::parser
