// What happens before the picture: the radiosity pretrace and the photon maps (spec 07 sections 2.9 and 3).
#pragma once

#include "tracer/film/errors.h"
#include "tracer/film/options.h"
#include "tracer/film/statistics.h"
#include "tracer/effects/scene_effects.h"
#include "tracer/render/sampling/pixel_sampler.h"

namespace verisim::render {

// Adds to options.rays what was traced.
void count_rays(const Options& options, const Statistics& traced);

// Fills effects.irradiance(). In replay mode one task works through all tiles and passes as `povray +WT1` does;
// otherwise the tiles of a pass run in parallel, each seeing the samples of earlier passes and its own, so that the
// cache does not depend on the number of threads.
void radiosity_pretrace(global::SceneEffects& effects, const shading::SceneData& data, const CameraModel& camera,
                        const Options& options, int threads);

// Shoots photons and builds the maps, or loads them from the scene's load_file.
void photon_pass(global::SceneEffects& effects, const shading::SceneData& data, const Options& options, int threads);

// Prepares a thread's tracer for the final trace of a block (radiosity samples taken there stay in the block, unless in
// replay).
void begin_block(global::SceneEffects& effects, shading::Tracer& tracer, const Options& options, int block);

// After the block: keeps its radiosity samples if they are to be saved.
void end_block(global::SceneEffects& effects, shading::Tracer& tracer, const Options& options, int block);

// Writes all radiosity samples to options.radiosity_to, if there is one; adds to the file they were loaded from.
void save_radiosity(global::SceneEffects& effects, const Options& options);

}  // namespace verisim::render
