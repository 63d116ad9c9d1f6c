// parametric (spec 04 section 7).
#include <algorithm>

#include "parser/scene/objects.h"
#include "parser/scene/shapes/contained_by.h"

namespace verisim::parser {

namespace {

void parse_precompute(Parser& parser, scene::Parametric& surface) {
  parser.next();
  surface.precompute_depth = parser.parse_int();
  parser.optional_comma();
  constexpr Word kAxes[] = {Word::x, Word::y, Word::z};
  for (std::size_t i = 0; i < 3; ++i) {
    if (parser.accept(kAxes[i])) surface.precompute[i] = true;
    parser.optional_comma();
  }
  const bool any = surface.precompute[0] || surface.precompute[1] || surface.precompute[2];
  if (any && (surface.precompute_depth < 1 || surface.precompute_depth > 20))
    parser.error(Code::bad_value, "Precompute: invalid depth.");
}

}  // namespace

ObjectRef parse_parametric(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    auto surface = std::make_shared<scene::Parametric>();
    for (FunctionPtr& function : surface->function) {
      if (parser.accept(Word::function)) {
        function = parser.parse_function_body();
      } else {
        function = parser.parse_function_or_identifier();
      }
      if (function->components() != 1 || function->parameters() != 3)
        parser.error(Code::missing_item, "A parametric surface needs float functions of u and v.");
      parser.optional_comma();
    }
    const Vec2 first = parser.parse_vec2();
    parser.optional_comma();
    const Vec2 second = parser.parse_vec2();
    surface->low = {std::min(first.x, second.x), std::min(first.y, second.y)};
    surface->high = {std::max(first.x, second.x), std::max(first.y, second.y)};
    for (;;) {
      switch (word_at(parser)) {
        case Word::contained_by:
          parse_contained_by(parser, surface->container);
          continue;
        case Word::accuracy:
          parser.next();
          surface->accuracy = parser.parse_float();
          continue;
        case Word::max_gradient:
          parser.next();
          surface->max_gradient = parser.parse_float();
          continue;
        case Word::precompute:
          parse_precompute(parser, *surface);
          continue;
        default:
          break;
      }
      break;
    }
    object.shape = std::shared_ptr<const scene::Parametric>(surface);
  });
}

}  // namespace verisim::parser
