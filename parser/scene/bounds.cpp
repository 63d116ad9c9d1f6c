// bounded_by { ... } and clipped_by { ... } (spec 03 sections 6.2 and 6.3).
#include <fmt/format.h>

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

// What bounded_by and clipped_by have in common; `other` is the word of the other one, which links the two lists. A
// link to a list that is still empty is none: both lists can be written later.
struct Guard {
  const char* plural;
  Word other;
  const char* other_plural;
};
void parse_guard(Parser& parser, Object& object, const Guard& guard, scene::List<ObjectPtr>& own,
                 const scene::List<ObjectPtr>& others) {
  const Parser::Depth depth(parser);
  open_block(parser);
  if (parser.accept(guard.other)) {
    if (!own.empty())
      parser.error(Code::incompatible,
                   fmt::format("Cannot link {} with previous {}.", guard.other_plural, guard.plural));
    own = others;
    object.clip_is_bound = !others.empty();
    close_block(parser);
    return;
  }
  if (object.clip_is_bound)
    parser.error(Code::incompatible, fmt::format("Cannot add {} after linking bounds and clips.", guard.plural));
  for (ObjectPtr& item : parse_objects(parser)) own.push_back(std::move(item));
}

}  // namespace

void parse_bounded_by(Parser& parser, Object& object) {
  parse_guard(parser, object, {"bounds", Word::clipped_by, "clips"}, object.bounded_by, object.clipped_by);
}
void parse_clipped_by(Parser& parser, Object& object) {
  const bool linked = object.clip_is_bound;
  parse_guard(parser, object, {"clips", Word::bounded_by, "bounds"}, object.clipped_by, object.bounded_by);
  object.clip_from_bound |= !linked && object.clip_is_bound;
}

}  // namespace verisim::parser
