// sphere { <center>, radius } (spec 03 4.1).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef parse_sphere(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::Sphere sphere;
    sphere.center = parser.parse_vec3();
    parser.optional_comma();
    sphere.radius = parser.parse_float();
    object.shape = sphere;
  });
}

}  // namespace verisim::parser
