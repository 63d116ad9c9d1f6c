// triangle and smooth_triangle (spec 03 4.7, 04 section 2).
#include "parser/scene/objects.h"

namespace verisim::parser {

namespace {

bool is_zero_area(const std::array<Vec3, 3>& p) { return length(cross(p[0] - p[1], p[2] - p[1])) == 0; }

void warn_degenerate(Parser& parser) { parser.warning(Code::degenerate, "Degenerate triangle. Please remove."); }

}  // namespace

ObjectRef parse_triangle(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      if (i > 0) parser.optional_comma();
      triangle.p[i] = parser.parse_vec3();
    }
    if (is_zero_area(triangle.p)) warn_degenerate(parser);
    object.shape = triangle;
  });
}

ObjectRef parse_smooth_triangle(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::SmoothTriangle triangle;
    bool zero_normal = false;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.p[i] = parser.parse_vec3();
      parser.optional_comma();
      triangle.n[i] = parser.parse_vec3();
      parser.optional_comma();
      if (length(triangle.n[i]) == 0)
        zero_normal = true;
      else
        triangle.n[i] = normalize(triangle.n[i]);
    }
    const Vec3 plane = cross(triangle.p[0] - triangle.p[1], triangle.p[2] - triangle.p[1]);
    int sides = 0;
    for (const Vec3& n : triangle.n) sides += dot(n, plane) > 0 ? 1 : dot(n, plane) < 0 ? -1 : 0;
    if (zero_normal || is_zero_area(triangle.p) || (sides != 3 && sides != -3)) warn_degenerate(parser);
    object.shape = triangle;
  });
}

}  // namespace verisim::parser
