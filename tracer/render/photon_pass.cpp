#include "tracer/render/prepasses.h"

namespace verisim::render {

void photon_pass(global::SceneEffects&, const shading::SceneData&, const Options&, int) {}

}  // namespace verisim::render
