// What the camera's rays meet first, beside the picture: for compositing (--layers) and denoising.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/math/color.h"
#include "tracer/math/vec.h"

namespace verisim::render {

struct Layers {
  // What is wanted.
  bool depth = false, normal = false, albedo = false, id = false;
  // One entry a pixel, row 0 at the top; empty when not wanted.
  std::vector<float> depths;       // distance from the ray's origin to the centre's hit; kFarDepth where there is none
  std::vector<Vec3> normals;       // world space, perturbed, towards the viewer; 0 where nothing was hit
  std::vector<Rgb> albedos;        // colour of the pigments, without light; 0 where nothing was hit
  std::vector<std::uint32_t> ids;  // number of the top-level object from 1 in order of the scene; 0: none
};
inline constexpr float kFarDepth = 1e10f;

}  // namespace verisim::render
