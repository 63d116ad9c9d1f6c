// What a render did, and what it found out about the scene.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tracer/scene/source_location.h"

namespace verisim::render {

struct Statistics {
  std::uint64_t pixels = 0, samples = 0, camera_rays = 0, reflected_rays = 0, refracted_rays = 0, shadow_rays = 0,
                transmitted_rays = 0;
  std::uint64_t wavefront_rays = 0;  // those from the camera that were traced with others
  double seconds_compile = 0, seconds_render = 0;
  bool cancelled = false;
  std::vector<std::pair<scene::SourceLocation, std::string>>
      findings;  // warnings about objects, and where those were written
};

}  // namespace verisim::render
