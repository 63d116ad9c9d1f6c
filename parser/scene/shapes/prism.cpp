// prism { [spline] [sweep] low, high, n, points [open] } (spec 03 4.17).
#include <algorithm>

#include "parser/scene/objects.h"
#include "parser/scene/shapes/spline_points.h"

namespace verisim::parser {

using scene::SplineKind;

namespace {

void check_count(Parser& parser, SplineKind spline, std::size_t count) {
  switch (spline) {
    case SplineKind::linear:
      if (count < 3) parser.error("Prism with linear splines must have at least three points.");
      break;
    case SplineKind::quadratic:
      if (count < 5) parser.error("Prism with quadratic splines must have at least five points.");
      break;
    case SplineKind::bezier:
      if (count < 4 || count % 4 != 0) parser.error("Prism with Bezier splines must have four points per segment.");
      break;
    default:
      if (count < 6) parser.error("Prism with cubic splines must have at least six points.");
      break;
  }
}

}  // namespace

ObjectRef parse_prism(Parser& parser) {
  return shape_block(parser, "prism", [&](scene::Object& object) {
    auto prism = std::make_shared<scene::Prism>();
    for (;;) {
      if (accept_spline_kind(parser, prism->spline)) continue;
      if (parser.accept(Word::linear_sweep)) {
        prism->conic = false;
      } else if (parser.accept(Word::conic_sweep)) {
        prism->conic = true;
      } else {
        break;
      }
    }
    prism->low = parser.parse_float();
    parser.optional_comma();
    prism->high = parser.parse_float();
    parser.optional_comma();
    if (prism->low > prism->high) std::swap(prism->low, prism->high);
    prism->points = parse_points(parser, "prism");
    check_count(parser, prism->spline, prism->points.size());
    prism->open = parser.accept(Word::open);
    object.shape = std::shared_ptr<const scene::Prism>(prism);
  });
}

}  // namespace verisim::parser
