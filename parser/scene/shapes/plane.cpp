// plane { <normal>, distance } (spec 03 4.5).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef parse_plane(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::Plane plane;
    plane.normal = parser.parse_vec3();
    if (!(length(plane.normal) >= kEpsilon)) parser.error(Code::degenerate, "Degenerate plane normal.");
    plane.normal = normalize(plane.normal);
    parser.optional_comma();
    plane.distance = parser.parse_float();
    object.shape = plane;
  });
}

}  // namespace verisim::parser
