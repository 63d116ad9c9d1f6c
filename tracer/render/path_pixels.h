// Pixels of the path integrator: samples spread over the pixel's area and the lens.
#pragma once

#include "tracer/path/path_tracer.h"
#include "tracer/render/blocks.h"
#include "tracer/render/sampling/pixel_sampler.h"

namespace verisim::render {

// Renders a block with options.path_samples paths a pixel. The result depends on pixel and seed alone.
void render_paths(const Block& block, const CameraModel& camera, const path::PathScene& scene, shading::Tracer& tracer,
                  const Options& options, const BlockPixels& out);

}  // namespace verisim::render
