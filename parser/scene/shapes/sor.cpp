// sor { n, points [open] } (spec 03 4.16).
#include <cmath>

#include "parser/scene/objects.h"
#include "parser/scene/shapes/spline_points.h"

namespace verisim::parser {

ObjectRef parse_sor(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    auto sor = std::make_shared<scene::Sor>();
    sor->points = parse_points(parser, "sor");
    const std::vector<Vec2>& p = sor->points;
    const std::size_t count = p.size();
    if (count < 4) parser.error(Code::too_few, "Surface of revolution must have at least four points.");
    for (std::size_t i = 0; i < count; ++i) {
      const bool inner = i > 1 && i + 1 < count;  // heights rise from the second to the last but one
      if (p[i].x < 0 || (inner && p[i].y <= p[i - 1].y))
        parser.error(Code::bad_value, "Incorrect point in surface of revolution.");
      if (i + 2 < count && std::fabs(p[i + 2].y - p[i].y) < kEpsilon)
        parser.error(Code::bad_value, "Incorrect point in surface of revolution.");
    }
    sor->open = parser.accept(Word::open);
    object.shape = std::shared_ptr<const scene::Sor>(sor);
  });
}

}  // namespace verisim::parser
