// One sample through the centre of a pixel, with somebody watching.
#pragma once

#include "tracer/render/render.h"
#include "tracer/shading/explain.h"

namespace verisim::render {

// The colour is that of a render without anti-aliasing. Serial; the passes before the picture (photons, radiosity) are made as for one. Throws Unsupported.
Color explain(const scene::Scene& scene, const Options& options, int x, int y, shading::Observer& observer);

}  // namespace verisim::render
