// What a scene asks for that this tracer does not render.
#pragma once

#include "tracer/render/render.h"

namespace verisim::render {

// Throws Unsupported for the first such feature that would show at this quality.
void check_supported(const scene::Scene& scene, const Options& options);

}  // namespace verisim::render
