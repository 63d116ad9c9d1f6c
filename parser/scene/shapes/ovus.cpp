// ovus { bottom radius, top radius } (spec 03 4.14).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef parse_ovus(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::Ovus ovus;
    ovus.bottom = parser.parse_float();
    parser.optional_comma();
    ovus.top = parser.parse_float();
    if (ovus.bottom < 0 || ovus.top < 0) parser.error(Code::bad_value, "Both Ovus radii must be positive.");
    if (ovus.top >= 2 * ovus.bottom) {
      parser.warning(Code::adjusted_value,
                     "Ovus second radius should be lower than twice the first radius. Substituting a sphere.");
      object.shape = scene::Sphere{Vec3(0, ovus.bottom, 0), ovus.top};
      return;
    }
    object.shape = ovus;
  });
}

}  // namespace verisim::parser
