// sphere_sweep { spline n, <center>, radius ... [tolerance t] } (spec 03 4.18).
#include "parser/scene/objects.h"
#include "parser/scene/shapes/spline_points.h"

namespace verisim::parser {

ObjectRef parse_sphere_sweep(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    auto sweep = std::make_shared<scene::SphereSweep>();
    if (!accept_spline_kind(parser, sweep->spline, true))
      parser.error(Code::unexpected_token, "Invalid type of interpolation.");
    parser.optional_comma();
    const std::size_t count =
        checked_count(parser, parser.parse_float(), "spheres of a sphere_sweep", sizeof(Vec3) + sizeof(double));
    if (count < (sweep->spline == scene::SplineKind::linear ? 2u : 4u))
      parser.error(Code::too_few, "Too few spheres in sphere_sweep.");
    for (std::size_t i = 0; i < count; ++i) {
      parser.optional_comma();
      sweep->centers.push_back(parser.parse_vec3());
      parser.optional_comma();
      sweep->radii.push_back(parser.parse_float());
    }
    if (parser.accept(Word::tolerance)) sweep->tolerance = parser.parse_float();
    object.shape = std::shared_ptr<const scene::SphereSweep>(sweep);
  });
}

}  // namespace verisim::parser
