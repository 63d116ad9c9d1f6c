// quadric { <A,B,C>, <D,E,F>, <G,H,I>, J } (spec 03 4.10).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef parse_quadric(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::Quadric quadric;
    for (Vec3* part : {&quadric.square, &quadric.mixed, &quadric.linear}) {
      *part = parser.parse_vec3();
      parser.optional_comma();
    }
    quadric.constant = parser.parse_float();
    object.shape = quadric;
  });
}

}  // namespace verisim::parser
