// What lathe, prism, sor and sphere_sweep have in common: the kind of spline and the list of points.
#pragma once

#include "parser/language/blocks.h"

namespace verisim::parser {

// linear_spline, quadratic_spline ...; `sweep`: the kinds of sphere_sweep. False: none here.
bool accept_spline_kind(Parser& parser, scene::SplineKind& kind, bool sweep = false);
// n, <x, y> ...
std::vector<Vec2> parse_points(Parser& parser, std::string_view name);

// How many points a linear, a quadratic and a cubic spline of a shape have at least.
struct FewestPoints {
  std::size_t linear, quadratic, cubic;
};
// An error for fewer, or for Bezier segments that are not whole; `shape` begins it.
void check_point_count(Parser& parser, std::string_view shape, scene::SplineKind kind, std::size_t count,
                       const FewestPoints& fewest);

}  // namespace verisim::parser
