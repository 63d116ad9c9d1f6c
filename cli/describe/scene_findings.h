// What makes a picture black although the scene has no errors: no light, a camera inside an opaque object.
#pragma once

#include <vector>

#include "parser/source/diagnostic.h"
#include "tracer/scene/scene.h"

namespace verisim::cli {

// Warnings; each is certain: a scene that shines in any way, or an object that anything can be seen through, gives
// none.
std::vector<parser::Diagnostic> scene_findings(const scene::Scene& scene);

}  // namespace verisim::cli
