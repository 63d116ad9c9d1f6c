// bounded_by { ... } and clipped_by { ... } (spec 03 sections 6.2 and 6.3).
#include "parser/scene/objects.h"
#include "parser/scene/common/nesting.h"
#include "parser/scene/common/transform.h"
#include "tracer/scene/parts.h"

namespace verisim::parser {

using scene::Object;
using scene::ObjectPtr;

namespace {

bool has_texture(const Object& object, scene::SharedLists& seen) {
  if (object.texture) return true;
  if (!object.as<scene::Csg>() || !seen.first(object)) return false;
  for (const ObjectPtr& child : scene::declared_children(object)) {
    if (has_texture(*child, seen)) return true;
  }
  return false;
}

// Objects up to the closing brace, then transformations for all of them.
std::vector<ObjectPtr> parse_objects(Parser& parser) {
  std::vector<ObjectPtr> objects;
  while (ObjectRef object = parse_object(parser)) {
    scene::SharedLists seen;
    if (has_texture(*object, seen) || scene::is_patch(*object))
      parser.error(Code::incompatible, "Illegal texture or patch in clip, bound or object pattern.");
    check_nesting(parser, *object);
    objects.push_back(object);
  }
  if (objects.empty()) parser.error_expected("object");
  for (;;) {
    Transform item;
    const Word word = word_at(parser);
    if (word == Word::translate || word == Word::rotate || word == Word::scale || word == Word::matrix ||
        word == Word::transform) {
      // Elementary steps are absorbed by each object on its own.
      Vec3 v;
      if (word == Word::translate || word == Word::rotate) {
        parser.next();
        v = parser.parse_vec3();
      } else if (word == Word::scale) {
        parser.next();
        v = parse_scale_vector(parser);
      } else {
        parse_transform_item(parser, item);
      }
      for (const ObjectPtr& pointer : objects) {
        auto& object = const_cast<Object&>(*pointer);
        if (word == Word::translate)
          scene::translate(object, v);
        else if (word == Word::rotate)
          scene::rotate(object, v);
        else if (word == Word::scale)
          scene::scale(object, v);
        else
          scene::transform(object, item);
      }
      continue;
    }
    break;
  }
  close_block(parser);
  return objects;
}

}  // namespace

// A link to a list that is still empty is none: both lists can be written later.
void parse_bounded_by(Parser& parser, Object& object) {
  const Parser::Depth depth(parser);
  open_block(parser);
  if (parser.accept(Word::clipped_by)) {
    if (!object.bounded_by.empty()) parser.error(Code::incompatible, "Cannot link clips with previous bounds.");
    object.bounded_by = object.clipped_by;
    object.clip_is_bound = !object.clipped_by.empty();
    close_block(parser);
    return;
  }
  if (object.clip_is_bound) parser.error(Code::incompatible, "Cannot add bounds after linking bounds and clips.");
  for (ObjectPtr& bound : parse_objects(parser)) object.bounded_by.push_back(std::move(bound));
}

void parse_clipped_by(Parser& parser, Object& object) {
  const Parser::Depth depth(parser);
  open_block(parser);
  if (parser.accept(Word::bounded_by)) {
    if (!object.clipped_by.empty()) parser.error(Code::incompatible, "Cannot link bounds with previous clips.");
    object.clipped_by = object.bounded_by;
    object.clip_is_bound = !object.bounded_by.empty();
    close_block(parser);
    return;
  }
  if (object.clip_is_bound) parser.error(Code::incompatible, "Cannot add clips after linking bounds and clips.");
  for (ObjectPtr& clip : parse_objects(parser)) object.clipped_by.push_back(std::move(clip));
}

}  // namespace verisim::parser
