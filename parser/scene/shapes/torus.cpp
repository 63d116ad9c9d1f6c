// torus { major, minor } (spec 03 4.4).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef parse_torus(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::Torus torus;
    torus.major = parser.parse_float();
    parser.optional_comma();
    torus.minor = parser.parse_float();
    object.shape = torus;
  });
}

}  // namespace verisim::parser
