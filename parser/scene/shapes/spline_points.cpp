#include "parser/scene/shapes/spline_points.h"

#include <fmt/format.h>

#include "parser/scene/common/common.h"

namespace verisim::parser {

bool accept_spline_kind(Parser& parser, scene::SplineKind& kind, bool sweep) {
  using scene::SplineKind;
  switch (word_at(parser)) {
    case Word::linear_spline:
      kind = SplineKind::linear;
      break;
    case Word::quadratic_spline:
      if (sweep) return false;
      kind = SplineKind::quadratic;
      break;
    case Word::cubic_spline:
      kind = SplineKind::cubic;
      break;
    case Word::bezier_spline:
      if (sweep) return false;
      kind = SplineKind::bezier;
      break;
    case Word::b_spline:
      if (!sweep) return false;
      kind = SplineKind::b_spline;
      break;
    default:
      return false;
  }
  parser.next();
  return true;
}

void check_point_count(Parser& parser, std::string_view shape, scene::SplineKind kind, std::size_t count,
                       const FewestPoints& fewest) {
  static constexpr const char* kNumbers[] = {"no", "one", "two", "three", "four", "five", "six"};
  const auto at_least = [&](const char* spline, std::size_t least) {
    if (count < least)
      parser.error(Code::too_few,
                   fmt::format("{} with {} splines must have at least {} points.", shape, spline, kNumbers[least]));
  };
  switch (kind) {
    case scene::SplineKind::linear:
      return at_least("linear", fewest.linear);
    case scene::SplineKind::quadratic:
      return at_least("quadratic", fewest.quadratic);
    case scene::SplineKind::bezier:
      if (count < 4 || count % 4 != 0)
        parser.error(Code::too_few, fmt::format("{} with Bezier splines must have four points per segment.", shape));
      return;
    default:
      return at_least("cubic", fewest.cubic);
  }
}

std::vector<Vec2> parse_points(Parser& parser, std::string_view name) {
  const std::size_t count =
      checked_count(parser, parser.parse_float(), "points of a " + std::string(name), sizeof(Vec2));
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < count; ++i) {
    parser.optional_comma();
    points.push_back(parser.parse_vec2());
  }
  return points;
}

}  // namespace verisim::parser
