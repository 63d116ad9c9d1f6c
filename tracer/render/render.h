// Rendering a scene to a framebuffer (specs 02, 06).
#pragma once

#include "tracer/film/errors.h"
#include "tracer/film/framebuffer.h"
#include "tracer/film/options.h"
#include "tracer/film/statistics.h"
#include "tracer/scene/scene.h"

namespace verisim::render {

// Throws Unsupported before any ray is shot; std::bad_alloc and friends pass through. A framebuffer that already has
// the size asked for keeps its pixels where nothing is rendered; any other is made anew, opaque black. The
// framebuffer of one of several parts (options.parts above 1) is a strip: its blocks alone, below one another in their
// order (strip_of in tracer/render/blocks.h).
Statistics render(const scene::Scene& scene, const Options& options, Framebuffer& framebuffer);

}  // namespace verisim::render
