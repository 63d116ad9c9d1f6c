// What a description asks its shape: boxes whose finding takes work, and standard positions. Each is defined in the
// file of the shape, tracer/shapes/.
#pragma once

#include <vector>

#include "tracer/scene/object.h"

namespace verisim::shapes {

// Boxes in the shape's own space (before its matrix), as POV-Ray stores them: see scene::local_bounds.
Box3 cone_box(const scene::Cone& cone);
Box3 polygon_box(const scene::Polygon& polygon);
Box3 ovus_box(const scene::Ovus& ovus);
Box3 blob_box(const scene::Blob& blob);
Box3 lathe_box(const scene::Lathe& lathe);
Box3 sor_box(const scene::Sor& sor);
Box3 prism_box(const scene::Prism& prism);
Box3 bicubic_patch_box(const scene::BicubicPatch& patch);
Box3 height_field_box(const scene::HeightField& field);
Box3 isosurface_box(const scene::Isosurface& isosurface);
Box3 parametric_box(const scene::Parametric& parametric);
Box3 julia_fractal_box(const scene::JuliaFractal& fractal);
// Of each letter of a text: its box where its outline has it, and the place of that.
struct LetterBox {
  Box3 box;
  Vec2 place;
};
std::vector<LetterBox> letter_boxes(const scene::Text& text);
Box3 mesh_box(const scene::Mesh& mesh);

// Shapes that are modelled in a standard position: the matrix that puts them where the scene wants them, before any
// transformation.
Transform cone_frame(const scene::Cone& cone);
Transform disc_frame(const scene::Disc& disc);
Transform polygon_frame(const scene::Polygon& polygon);
Transform text_frame();
Transform height_field_frame(const scene::HeightField& field);  // of its grid

}  // namespace verisim::shapes
