// What the passes before the picture have found, as bytes: made once, read by all that render a part of the picture.
#pragma once

#include <string>
#include <string_view>

#include "tracer/effects/scene_effects.h"
#include "tracer/film/options.h"

namespace verisim::render {

// Photons and radiosity samples, to the last bit and in their order, so that a picture made with them is the one that
// is made without.
std::string write_prepasses(global::SceneEffects& effects);
// Into the maps and the cache of effects that hold nothing yet. Throws std::runtime_error for bytes that are none of
// write_prepasses.
void read_prepasses(std::string_view bytes, global::SceneEffects& effects, const Options& options);

}  // namespace verisim::render
