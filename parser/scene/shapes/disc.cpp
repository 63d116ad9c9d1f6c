// disc { <center>, <normal>, radius [, hole radius] } (spec 03 4.6).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef parse_disc(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::Disc disc;
    disc.center = parser.parse_vec3();
    parser.optional_comma();
    disc.normal = parser.parse_vec3();
    parser.optional_comma();
    disc.radius = parser.parse_float();
    parser.optional_comma();
    disc.hole = parser.parse_optional_float(0);
    object.shape = disc;
  });
}

}  // namespace verisim::parser
