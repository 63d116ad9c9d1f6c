// One factory per shape, in the file of its name; compile.cpp dispatches to them. And the boxes of shapes whose extent takes work to find.
#pragma once

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

// Boxes in the shape's own space (before its matrix), as POV-Ray stores them: see scene::local_bounds.
Box3 cone_box(const scene::Cone& cone);
Box3 polygon_box(const scene::Polygon& polygon);
Box3 ovus_box(const scene::Ovus& ovus);
Box3 blob_box(const scene::Blob& blob);
Box3 lathe_box(const scene::Lathe& lathe);
Box3 sor_box(const scene::Sor& sor);
Box3 prism_box(const scene::Prism& prism);
Box3 bicubic_patch_box(const scene::BicubicPatch& patch);
// False: the patch would be divided into more pieces than fit into memory.
bool bicubic_patch_fits(const scene::BicubicPatch& patch);
Box3 height_field_box(const scene::HeightField& field);
Box3 isosurface_box(const scene::Isosurface& isosurface);
Box3 parametric_box(const scene::Parametric& parametric);
Box3 julia_fractal_box(const scene::JuliaFractal& fractal);
Box3 text_box(const scene::Text& text);
Box3 mesh_box(const scene::Mesh& mesh);


// Shapes that are modelled in a standard position: the matrix that puts them where the scene wants them, before any transformation.
Transform cone_frame(const scene::Cone& cone);
Transform disc_frame(const scene::Disc& disc);
Transform polygon_frame(const scene::Polygon& polygon);

}  // namespace verisim::shapes
