// superellipsoid { <e, n> } (spec 03 4.12).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef parse_superellipsoid(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    const Vec2 exponents = parser.parse_vec2();
    object.shape = scene::Superellipsoid{exponents.x, exponents.y};
  });
}

}  // namespace verisim::parser
