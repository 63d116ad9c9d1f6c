// box { <corner>, <corner> } (spec 03 4.2).
#include <algorithm>

#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef parse_box(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::Box box;
    box.low = parser.parse_vec3();
    parser.optional_comma();
    box.high = parser.parse_vec3();
    for (unsigned i = 0; i < 3; ++i) {
      if (box.low[i] > box.high[i]) std::swap(box.low[i], box.high[i]);
    }
    object.shape = box;
  });
}

}  // namespace verisim::parser
