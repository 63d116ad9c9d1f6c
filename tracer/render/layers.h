// Fills the layers beside the picture (tracer/film/layers.h).
#pragma once

#include "tracer/film/layers.h"
#include "tracer/render/sampling/antialias.h"
#include "tracer/render/sampling/pixel_sampler.h"

namespace verisim::render {

// Fills what is wanted for a block. Depths and numbers belong to the pixel's centre, as compositing
// needs them; normals and albedos are means over the pixel when `antialias`. Focal blur is left out. Blocks may be
// filled from several threads.
void resize_layers(Layers& layers, int width, int height);
void fill_layers(Layers& layers, const shading::SceneData& scene, const CameraModel& camera, int width,
                 const Block& block, bool antialias);

}  // namespace verisim::render
