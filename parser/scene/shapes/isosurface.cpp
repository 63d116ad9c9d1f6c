// isosurface (spec 04 section 6).
#include "parser/scene/objects.h"
#include "parser/scene/shapes/contained_by.h"

namespace verisim::parser {

namespace {

void parse_max_trace(Parser& parser, scene::Isosurface& surface) {
  parser.next();
  surface.max_trace = parser.parse_int();
  if (surface.max_trace > 10) {
    parser.warning(Code::adjusted_value, "Isosurface 'max_trace' exceeds maximum of 10. Using maximum.");
    surface.max_trace = 10;
  } else if (surface.max_trace < 1) {
    parser.warning(Code::adjusted_value, "Isosurface 'max_trace' is not positive. Using 1 (default).");
    surface.max_trace = 1;
  }
}

void parse_evaluate(Parser& parser, scene::Isosurface& surface) {
  parser.next();
  Vec3 values;
  for (unsigned i = 0; i < 3; ++i) {
    values[i] = parser.parse_float();
    if (i < 2) parser.optional_comma();
  }
  surface.evaluate = values;
}

}  // namespace

ObjectRef parse_isosurface(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    auto surface = std::make_shared<scene::Isosurface>();
    parser.expect(Word::function);
    if (!parser.at('{')) parser.error_expected("{");  // always in x, y, z
    surface->function = parser.parse_function_body();
    if (surface->function->components() != 1 || surface->function->parameters() != 3)
      parser.error(Code::missing_item, "An isosurface needs a float function of x, y, z.");
    for (;;) {
      switch (word_at(parser)) {
        case Word::contained_by:
          parse_contained_by(parser, surface->container);
          continue;
        case Word::threshold:
          parser.next();
          surface->threshold = parser.parse_float();
          continue;
        case Word::accuracy:
          parser.next();
          surface->accuracy = parser.parse_float();
          if (!(surface->accuracy > 0)) {
            parser.warning(Code::adjusted_value, "Isosurface 'accuracy' is not positive. Using 0.001 (default).");
            surface->accuracy = 0.001;
          }
          continue;
        case Word::max_gradient:
          parser.next();
          surface->max_gradient = parser.parse_float();
          if (!(surface->max_gradient > 0)) {
            parser.warning(Code::adjusted_value, "Isosurface 'max_gradient' is not positive. Using 1.1 (default).");
            surface->max_gradient = 1.1;
          }
          continue;
        case Word::evaluate:
          parse_evaluate(parser, *surface);
          continue;
        case Word::open:
          parser.next();
          surface->open = true;
          continue;
        case Word::max_trace:
          parse_max_trace(parser, *surface);
          continue;
        case Word::all_intersections:
          parser.next();
          surface->max_trace = 10;
          continue;
        default:
          break;
      }
      break;
    }
    object.shape = std::shared_ptr<const scene::Isosurface>(surface);
  });
}

}  // namespace verisim::parser
