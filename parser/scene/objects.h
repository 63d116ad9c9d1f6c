// The frame that all object statements share, and their single readers.
#pragma once

#include "parser/keywords/object_statements.h"
#include "parser/scene/common/common.h"

namespace verisim::parser {

using ObjectRef = std::shared_ptr<scene::Object>;

// If an identifier of an object is at the cursor: a copy of it.
ObjectRef accept_object_copy(Parser& parser);
// The same in the place of a shape's parameters, of which scenes before 1.5 are warned.
ObjectRef accept_object_instead(Parser& parser);

// Items after the shape's own parameters, up to and including the closing brace (spec 03 section 6).
void parse_object_modifiers(Parser& parser, scene::Object& object);

// `KEYWORD { parameters modifiers }` or `KEYWORD { IDENTIFIER modifiers }`: an identifier as the first item makes the
// statement a copy of that object, whatever its shape (spec 01 section 6), and takes the ordinary modifiers (a
// light_group its own). `read_modifiers` stops before the closing brace.
template <class ReadShape, class ReadModifiers>
ObjectRef object_block(Parser& parser, std::string_view name, const ReadShape& read_shape,
                       const ReadModifiers& read_modifiers) {
  Block block(parser);
  if (ObjectRef copied = accept_object_instead(parser)) {
    if (name == "light_group" && std::holds_alternative<scene::LightGroup>(copied->shape)) {
      read_modifiers(*copied);
      block.close();
    } else {
      parse_object_modifiers(parser, *copied);
    }
    copied->place = block.place;
    return copied;
  }
  auto object = std::make_shared<scene::Object>();
  object->place = block.place;
  read_shape(*object);
  scene::compute_bounds(*object);
  read_modifiers(*object);
  block.close();
  return object;
}

// The same for shapes with the ordinary modifiers.
template <class ReadShape>
ObjectRef shape_block(Parser& parser, const ReadShape& read_shape) {
  Block block(parser);
  ObjectRef object = accept_object_instead(parser);
  if (!object) {
    object = std::make_shared<scene::Object>();
    read_shape(*object);
    scene::compute_bounds(*object);
  }
  object->place = block.place;
  parse_object_modifiers(parser, *object);
  // These boxes are made after the modifiers, of which bounds do not cut them down, and none moves them from step to
  // step (spec 03 2.2).
  if (!object->copied &&
      (object->as<std::shared_ptr<const scene::Blob>>() || object->as<std::shared_ptr<const scene::HeightField>>() ||
       object->as<std::shared_ptr<const scene::JuliaFractal>>()))
    scene::compute_bounds(*object);
  return object;
}

void parse_bounded_by(Parser& parser, scene::Object& object);
void parse_clipped_by(Parser& parser, scene::Object& object);

// Most are in parser/scene/shapes.
#define VERISIM_OBJECT(word, reader) ObjectRef parse_##reader(Parser& parser);
VERISIM_OBJECT_STATEMENTS(VERISIM_OBJECT)
#undef VERISIM_OBJECT

}  // namespace verisim::parser
