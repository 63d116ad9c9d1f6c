// One factory per shape, in the file of its name; compile.cpp dispatches to them.
#pragma once

#include "tracer/scene/extents.h"
#include "tracer/shapes/shape.h"

namespace verisim::shapes {

std::unique_ptr<Shape> compile_sphere(const scene::Object& object);
std::unique_ptr<Shape> compile_box(const scene::Object& object);
std::unique_ptr<Shape> compile_plane(const scene::Object& object);
std::unique_ptr<Shape> compile_cone(const scene::Object& object);
std::unique_ptr<Shape> compile_torus(const scene::Object& object);
std::unique_ptr<Shape> compile_disc(const scene::Object& object);
std::unique_ptr<Shape> compile_triangle(const scene::Object& object);
std::unique_ptr<Shape> compile_smooth_triangle(const scene::Object& object);
std::unique_ptr<Shape> compile_polygon(const scene::Object& object);
std::unique_ptr<Shape> compile_poly(const scene::Object& object);
std::unique_ptr<Shape> compile_quadric(const scene::Object& object);
std::unique_ptr<Shape> compile_superellipsoid(const scene::Object& object);
std::unique_ptr<Shape> compile_ovus(const scene::Object& object);
std::unique_ptr<Shape> compile_blob(const scene::Object& object);
std::unique_ptr<Shape> compile_lathe(const scene::Object& object);
std::unique_ptr<Shape> compile_sor(const scene::Object& object);
std::unique_ptr<Shape> compile_prism(const scene::Object& object);
std::unique_ptr<Shape> compile_sphere_sweep(const scene::Object& object);
std::unique_ptr<Shape> compile_bicubic_patch(const scene::Object& object);
std::unique_ptr<Shape> compile_height_field(const scene::Object& object);
std::unique_ptr<Shape> compile_isosurface(const scene::Object& object);
std::unique_ptr<Shape> compile_parametric(const scene::Object& object);
std::unique_ptr<Shape> compile_julia_fractal(const scene::Object& object);
std::unique_ptr<Shape> compile_text(const scene::Object& object);
std::unique_ptr<Shape> compile_mesh(const scene::Object& object);
std::unique_ptr<Shape> compile_csg(const scene::Object& object);
std::unique_ptr<Shape> compile_light(const scene::Object& object);  // light_source and light_group

// False: the patch would be divided into more pieces than fit into memory.
bool bicubic_patch_fits(const scene::BicubicPatch& patch);

}  // namespace verisim::shapes
