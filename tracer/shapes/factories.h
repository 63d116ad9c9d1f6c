// One factory per shape, in the file of its name; compile.cpp dispatches to them.
#pragma once

#include "tracer/scene/extents.h"
#include "tracer/shapes/shape.h"

namespace verisim::shapes {

#define VERISIM_SHAPE(held, name) std::unique_ptr<Shape> compile_##name(const scene::Object& object);
VERISIM_SHAPES(VERISIM_SHAPE)
#undef VERISIM_SHAPE

// False: the patch would be divided into more pieces than fit into memory.
bool bicubic_patch_fits(const scene::BicubicPatch& patch);

}  // namespace verisim::shapes
