// polygon { n, points } (spec 03 4.8): sub-polygons are closed by repeating their first point.
#include <cmath>

#include "parser/scene/objects.h"

namespace verisim::parser {

namespace {

bool same_point(const Vec3& a, const Vec3& b) {
  return std::fabs(a.x - b.x) < kEpsilon && std::fabs(a.y - b.y) < kEpsilon && std::fabs(a.z - b.z) < kEpsilon;
}

// Makes repeated first points exactly equal and closes a last outline that is open.
void close_outlines(Parser& parser, std::vector<Vec3>& points) {
  bool open = false;
  std::size_t first = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!open) {
      first = i;
      open = true;
    } else if (same_point(points[i], points[first])) {
      points[i] = points[first];
      open = false;
    }
  }
  if (!open) return;
  parser.warning(Code::not_closed, "Polygon not closed. Closing it.");
  points.push_back(points[first]);
}

}  // namespace

ObjectRef parse_polygon(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    const std::size_t count = checked_count(parser, parser.parse_float(), "points of a polygon", sizeof(Vec3));
    if (count < 3) parser.error(Code::too_few, "Polygon needs at least three points.");
    scene::Polygon polygon;
    for (std::size_t i = 0; i < count; ++i) {
      parser.optional_comma();
      polygon.points.push_back(parser.parse_vec3());
    }
    close_outlines(parser, polygon.points);
    object.shape = std::move(polygon);
  });
}

}  // namespace verisim::parser
