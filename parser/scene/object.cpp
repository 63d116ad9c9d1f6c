// Which object a keyword starts; object { ... } and bare identifiers (spec 01 section 6, 03).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef accept_object_copy(Parser& parser) {
  const auto* value = parser.accept_value<scene::ObjectPtr>();
  if (!value) return nullptr;
  ObjectRef object = scene::copy(**value);
  if (auto* group = std::get_if<scene::LightGroup>(&object->shape)) group->from_identifier = true;
  return object;
}

namespace {

// object { IDENTIFIER modifiers } or object { STATEMENT modifiers }
ObjectRef parse_object_statement(Parser& parser) {
  Block block(parser);
  ObjectRef object = parse_object(parser);
  if (!object) parser.error_expected("object");
  if (object->copied) object->place = parser.copied_to(object->place, block.place);
  parse_object_modifiers(parser, *object);
  return object;
}

}  // namespace

ObjectRef parse_object(Parser& parser) {
  switch (word_at(parser)) {
    case Word::none:
      return accept_object_copy(parser);
    case Word::bicubic_patch:
      return parse_bicubic_patch(parser);
    case Word::blob:
      return parse_blob(parser);
    case Word::box:
      return parse_box(parser);
    case Word::cone:
      return parse_cone(parser);
    case Word::cubic:
    case Word::quartic:
    case Word::poly:
      return parse_poly(parser);
    case Word::cylinder:
      return parse_cylinder(parser);
    case Word::composite:
    case Word::difference:
    case Word::intersection:
    case Word::merge:
    case Word::union_:
      return parse_csg(parser);
    case Word::disc:
      return parse_disc(parser);
    case Word::height_field:
      return parse_height_field(parser);
    case Word::isosurface:
      return parse_isosurface(parser);
    case Word::julia_fractal:
      return parse_julia_fractal(parser);
    case Word::lathe:
      return parse_lathe(parser);
    case Word::light_group:
      return parse_light_group(parser);
    case Word::light_source:
      return parse_light_source(parser);
    case Word::mesh:
      return parse_mesh(parser);
    case Word::mesh2:
      return parse_mesh2(parser);
    case Word::object:
      return parse_object_statement(parser);
    case Word::ovus:
      return parse_ovus(parser);
    case Word::parametric:
      return parse_parametric(parser);
    case Word::plane:
      return parse_plane(parser);
    case Word::polygon:
      return parse_polygon(parser);
    case Word::polynomial:
      return parse_polynomial(parser);
    case Word::prism:
      return parse_prism(parser);
    case Word::quadric:
      return parse_quadric(parser);
    case Word::smooth_triangle:
      return parse_smooth_triangle(parser);
    case Word::sor:
      return parse_sor(parser);
    case Word::sphere:
      return parse_sphere(parser);
    case Word::sphere_sweep:
      return parse_sphere_sweep(parser);
    case Word::superellipsoid:
      return parse_superellipsoid(parser);
    case Word::text:
      return parse_text(parser);
    case Word::torus:
      return parse_torus(parser);
    case Word::triangle:
      return parse_triangle(parser);
    default:
      return nullptr;
  }
}

}  // namespace verisim::parser
