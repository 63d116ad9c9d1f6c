// What in a scene makes its picture noisy, so that a comparison judges it by statistics (spec 07 section 6).
#pragma once

#include <string>
#include <vector>

#include "tracer/scene/scene.h"

namespace verisim::cli {

// In words, each once: "area_light jitter", "radiosity", ... Empty: the scene has no random element. `quality` switches
// features off (spec 02 section 8).
std::vector<std::string> stochastic_features(const scene::Scene& scene, int quality);

// How many objects are finite, infinite and light sources, for the statistics.
struct ObjectCount {
  int finite = 0, infinite = 0, lights = 0;
};
ObjectCount count_objects(const scene::Scene& scene);

}  // namespace verisim::cli
