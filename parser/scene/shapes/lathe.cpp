// lathe { [spline] n, points } (spec 03 4.15).
#include "parser/scene/objects.h"
#include "parser/scene/shapes/spline_points.h"

namespace verisim::parser {

ObjectRef parse_lathe(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    auto lathe = std::make_shared<scene::Lathe>();
    accept_spline_kind(parser, lathe->spline);
    lathe->points = parse_points(parser, "lathe");
    const std::size_t count = lathe->points.size();
    check_point_count(parser, "Lathe", lathe->spline, count, {.linear = 2, .quadratic = 3, .cubic = 4});
    for (std::size_t i = 1; i + 1 < count; ++i) {
      if (lathe->points[i].x < 0) parser.error(Code::bad_value, "Incorrect point in lathe.");
    }
    object.shape = std::shared_ptr<const scene::Lathe>(lathe);
  });
}

}  // namespace verisim::parser
