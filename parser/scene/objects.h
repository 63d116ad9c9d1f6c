// The frame that all object statements share, and their single readers.
#pragma once

#include "parser/scene/common/common.h"

namespace verisim::parser {

using ObjectRef = std::shared_ptr<scene::Object>;

// If an identifier of an object is at the cursor: a copy of it.
ObjectRef accept_object_copy(Parser& parser);

// Items after the shape's own parameters, up to and including the closing brace (spec 03 section 6).
void parse_object_modifiers(Parser& parser, scene::Object& object);

// `KEYWORD { parameters modifiers }` or `KEYWORD { IDENTIFIER modifiers }`: an identifier as the first item makes the
// statement a copy of that object, whatever its shape (spec 01 section 6), and takes the ordinary modifiers (a
// light_group its own). `read_modifiers` stops before the closing brace.
template <class ReadShape, class ReadModifiers>
ObjectRef object_block(Parser& parser, std::string_view name, const ReadShape& read_shape,
                       const ReadModifiers& read_modifiers) {
  Block block(parser);
  if (ObjectRef copied = accept_object_copy(parser)) {
    if (name == "light_group" && std::holds_alternative<scene::LightGroup>(copied->shape)) {
      read_modifiers(*copied);
      block.close();
    } else {
      parse_object_modifiers(parser, *copied);
    }
    copied->place = block.place;
    return copied;
  }
  auto object = std::make_shared<scene::Object>();
  object->place = block.place;
  read_shape(*object);
  scene::compute_bounds(*object);
  read_modifiers(*object);
  block.close();
  return object;
}

// The same for shapes with the ordinary modifiers.
template <class ReadShape>
ObjectRef shape_block(Parser& parser, const ReadShape& read_shape) {
  Block block(parser);
  ObjectRef object = accept_object_copy(parser);
  if (!object) {
    object = std::make_shared<scene::Object>();
    read_shape(*object);
    scene::compute_bounds(*object);
  }
  object->place = block.place;
  parse_object_modifiers(parser, *object);
  return object;
}

void parse_bounded_by(Parser& parser, scene::Object& object);
void parse_clipped_by(Parser& parser, scene::Object& object);

ObjectRef parse_csg(Parser& parser);  // union, merge, intersection, difference, composite
ObjectRef parse_light_source(Parser& parser);
ObjectRef parse_light_group(Parser& parser);

// parser/scene/shapes
ObjectRef parse_bicubic_patch(Parser& parser);
ObjectRef parse_blob(Parser& parser);
ObjectRef parse_box(Parser& parser);
ObjectRef parse_cone(Parser& parser);
ObjectRef parse_cylinder(Parser& parser);
ObjectRef parse_disc(Parser& parser);
ObjectRef parse_height_field(Parser& parser);
ObjectRef parse_isosurface(Parser& parser);
ObjectRef parse_julia_fractal(Parser& parser);
ObjectRef parse_lathe(Parser& parser);
ObjectRef parse_mesh(Parser& parser);
ObjectRef parse_mesh2(Parser& parser);
ObjectRef parse_ovus(Parser& parser);
ObjectRef parse_parametric(Parser& parser);
ObjectRef parse_plane(Parser& parser);
ObjectRef parse_poly(Parser& parser);  // cubic, quartic, poly
ObjectRef parse_polygon(Parser& parser);
ObjectRef parse_polynomial(Parser& parser);
ObjectRef parse_prism(Parser& parser);
ObjectRef parse_quadric(Parser& parser);
ObjectRef parse_smooth_triangle(Parser& parser);
ObjectRef parse_sor(Parser& parser);
ObjectRef parse_sphere(Parser& parser);
ObjectRef parse_sphere_sweep(Parser& parser);
ObjectRef parse_superellipsoid(Parser& parser);
ObjectRef parse_text(Parser& parser);
ObjectRef parse_torus(Parser& parser);
ObjectRef parse_triangle(Parser& parser);

}  // namespace verisim::parser
