// prism { [spline] [sweep] low, high, n, points [open] } (spec 03 4.17).
#include <algorithm>
#include <cmath>

#include "parser/scene/objects.h"
#include "parser/scene/shapes/spline_points.h"

namespace verisim::parser {

using scene::SplineKind;

namespace {

bool same(const Vec2& a, const Vec2& b) { return std::fabs(a.x - b.x) < kEpsilon && std::fabs(a.y - b.y) < kEpsilon; }

// How many outlines there are before one that does not close, and whether that is all of them. A segment is made of
// `reach` + 1 points: it leads from the one at `begin` to the one at `end`; an outline ends with the segment that comes
// back to its first point.
struct Outlines {
  int closed = 0;
  bool all = true;
};

Outlines outlines(const std::vector<Vec2>& p, std::size_t begin, std::size_t end, std::size_t reach, bool chained) {
  Outlines result;
  const std::size_t step = chained ? 1 : reach + 1;
  for (std::size_t i = 0; i + reach < p.size();) {
    const Vec2 first = p[i + begin];
    bool closed = false;
    for (; i + reach < p.size() && !closed; i += step) closed = same(p[i + end], first);
    if (!closed) return {result.closed, false};
    ++result.closed;
    if (chained) i += reach;
  }
  return result;
}

void check_closed(Parser& parser, const scene::Prism& prism) {
  Outlines found;
  switch (prism.spline) {
    case SplineKind::linear:
      if (!outlines(prism.points, 0, 1, 1, true).all)
        parser.warning(Code::not_closed, "Linear prism not closed. Closing it.");
      return;
    case SplineKind::quadratic:
      found = outlines(prism.points, 1, 2, 2, true);
      break;
    case SplineKind::bezier:
      found = outlines(prism.points, 0, 3, 3, false);
      break;
    default:
      found = outlines(prism.points, 1, 2, 3, true);
      break;
  }
  if (found.all) return;
  parser.warning(Code::not_closed, "Prism not closed. Ignoring it.");
  if (prism.spline != SplineKind::bezier && !found.closed) parser.error(Code::too_few, "Too few points in prism.");
}

}  // namespace

ObjectRef parse_prism(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
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
    check_point_count(parser, "Prism", prism->spline, prism->points.size(), {.linear = 3, .quadratic = 5, .cubic = 6});
    check_closed(parser, *prism);
    prism->open = parser.accept(Word::open);
    object.shape = std::shared_ptr<const scene::Prism>(prism);
  });
}

}  // namespace verisim::parser
