// disc { <center>, <normal>, radius [, hole radius] } (spec 03 4.6).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef parse_disc(Parser& parser) {
  return shape_block(parser, "disc", [&](scene::Object& object) {
    scene::Disc disc;
    disc.center = parser.parse_vec3();
    parser.optional_comma();
    disc.normal = parser.parse_vec3();
    parser.optional_comma();
    disc.radius = parser.parse_float();
    if (accept_comma_or_number(parser)) disc.hole = parser.parse_float();
    object.shape = disc;
  });
}

}  // namespace verisim::parser
