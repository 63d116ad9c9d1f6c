// Which object a keyword starts; object { ... } and bare identifiers (spec 01 section 6, 03).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef accept_object_copy(Parser& parser) {
  const auto* value = parser.accept_value<scene::ObjectPtr>();
  if (!value) return nullptr;
  ObjectRef object = scene::copy(**value);
  if (auto* group = std::get_if<scene::LightGroup>(&object->shape)) group->from_identifier = true;
  return object;
}

ObjectRef accept_object_instead(Parser& parser) {
  ObjectRef object = accept_object_copy(parser);
  if (object && parser.version() < 150)
    parser.warning(Code::misplaced_keyword, "Found 'object identifier' that should be in an object statement.");
  return object;
}

// object { IDENTIFIER modifiers } or object { STATEMENT modifiers }
ObjectRef parse_object_statement(Parser& parser) {
  Block block(parser);
  ObjectRef object = parse_object(parser);
  if (!object) parser.error_expected("object");
  if (object->copied) object->place = parser.copied_to(object->place, block.place);
  parse_object_modifiers(parser, *object);
  return object;
}

ObjectRef parse_object(Parser& parser) {
  switch (word_at(parser)) {
    case Word::none:
      return accept_object_copy(parser);
#define VERISIM_OBJECT(word, reader) \
  case Word::word:                   \
    return parse_##reader(parser);
      VERISIM_OBJECT_STATEMENTS(VERISIM_OBJECT)
#undef VERISIM_OBJECT
    default:
      return nullptr;
  }
}

}  // namespace verisim::parser
