#include "parser/scene/shapes/contained_by.h"

#include <algorithm>

#include "parser/scene/common/common.h"

namespace verisim::parser {

void parse_contained_by(Parser& parser, scene::Contained& container) {
  Block block(parser);
  if (parser.accept(Word::box)) {
    parser.expect('{');
    container.sphere = false;
    container.low = parser.parse_vec3();
    parser.optional_comma();
    container.high = parser.parse_vec3();
    close_block(parser);
    for (unsigned i = 0; i < 3; ++i) {
      if (container.low[i] > container.high[i]) std::swap(container.low[i], container.high[i]);
    }
  } else if (parser.accept(Word::sphere)) {
    parser.expect('{');
    container.sphere = true;
    container.center = parser.parse_vec3();
    parser.optional_comma();
    container.radius = parser.parse_float();
    close_block(parser);
  }
  block.close();
}

}  // namespace verisim::parser
