// cone and cylinder, with an optional `open` directly behind the numbers (spec 03 4.3).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef parse_cone(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::Cone cone;
    cone.base = parser.parse_vec3();
    parser.optional_comma();
    cone.base_radius = parser.parse_float();
    parser.optional_comma();
    cone.cap = parser.parse_vec3();
    parser.optional_comma();
    cone.cap_radius = parser.parse_float();
    cone.open = parser.accept(Word::open);
    if (!(length(cone.base - cone.cap) >= kEpsilon)) parser.error(Code::degenerate, "Degenerate cone/cylinder.");
    object.shape = cone;
  });
}

ObjectRef parse_cylinder(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::Cone cylinder;
    cylinder.base = parser.parse_vec3();
    parser.optional_comma();
    cylinder.cap = parser.parse_vec3();
    parser.optional_comma();
    cylinder.base_radius = cylinder.cap_radius = parser.parse_float();
    cylinder.open = parser.accept(Word::open);
    if (!(length(cylinder.base - cylinder.cap) >= kEpsilon))
      parser.error(Code::degenerate, "Degenerate cylinder, base point = apex point.");
    object.shape = cylinder;
  });
}

}  // namespace verisim::parser
