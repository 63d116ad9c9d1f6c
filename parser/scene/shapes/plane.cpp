// plane { <normal>, distance } (spec 03 4.5).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef parse_plane(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::Plane plane;
    plane.normal = parser.parse_vec3();
    const double size = length(plane.normal);
    if (!(size >= kEpsilon)) parser.error(Code::degenerate, "Degenerate plane normal.");
    plane.normal = plane.normal / size;
    parser.optional_comma();
    plane.distance = parser.parse_float();
    object.shape = plane;
  });
}

}  // namespace verisim::parser
