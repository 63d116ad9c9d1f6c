// lathe { [spline] n, points } (spec 03 4.15).
#include "parser/scene/objects.h"
#include "parser/scene/shapes/spline_points.h"

namespace verisim::parser {

using scene::SplineKind;

ObjectRef parse_lathe(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    auto lathe = std::make_shared<scene::Lathe>();
    accept_spline_kind(parser, lathe->spline);
    lathe->points = parse_points(parser, "lathe");
    const std::size_t count = lathe->points.size();
    switch (lathe->spline) {
      case SplineKind::linear:
        if (count < 2) parser.error(Code::too_few, "Lathe with linear splines must have at least two points.");
        break;
      case SplineKind::quadratic:
        if (count < 3) parser.error(Code::too_few, "Lathe with quadratic splines must have at least three points.");
        break;
      case SplineKind::bezier:
        if (count < 4 || count % 4 != 0)
          parser.error(Code::too_few, "Lathe with Bezier splines must have four points per segment.");
        break;
      default:
        if (count < 4) parser.error(Code::too_few, "Lathe with cubic splines must have at least four points.");
        break;
    }
    for (std::size_t i = 1; i + 1 < count; ++i) {
      if (lathe->points[i].x < 0) parser.error(Code::bad_value, "Incorrect point in lathe.");
    }
    object.shape = std::shared_ptr<const scene::Lathe>(lathe);
  });
}

}  // namespace verisim::parser
