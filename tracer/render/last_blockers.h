// POV-Ray's shadow cache where it shows (spec 08 D), for blocks that are rendered in any order on any threads.
#pragma once

#include <span>
#include <vector>

#include "tracer/film/options.h"
#include "tracer/render/sampling/antialias.h"
#include "tracer/render/sampling/pixel_sampler.h"
#include "tracer/shading/tracer.h"

namespace verisim::render {

// What is remembered where each block begins, found by a coarse trace of all of them in order: every fourth pixel, and
// the last row, which mostly decides. Empty if nothing hangs on it.
std::vector<shading::LastBlockers> blockers_at_blocks(const shading::SceneData& scene, const CameraModel& camera,
                                                      const Options& options, std::span<const Block> blocks);

}  // namespace verisim::render
