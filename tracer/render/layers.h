// What the camera's rays meet first, beside the picture: for compositing (--layers) and denoising.
#pragma once

#include <vector>

#include "tracer/render/pixel_sampler.h"

namespace verisim::render {

struct Layers {
  // What is wanted.
  bool depth = false, normal = false, albedo = false, id = false;
  // One entry a pixel, row 0 at the top; empty when not wanted.
  std::vector<float> depths;   // distance from the ray's origin to the centre's hit; kFarDepth where there is none
  std::vector<Vec3> normals;   // world space, perturbed, towards the viewer; 0 where nothing was hit
  std::vector<Rgb> albedos;    // colour of the pigments, without light; 0 where nothing was hit
  std::vector<std::uint32_t> ids;  // number of the top-level object from 1 in order of the scene; 0: none
};
inline constexpr float kFarDepth = 1e10f;

// Fills what is wanted for the rows [first, last). Depths and numbers belong to the pixel's centre, as compositing needs them; normals and albedos are means over
// the pixel when `antialias`. Focal blur is left out. Rows may be filled from several threads.
void resize_layers(Layers& layers, int width, int height);
void fill_layers(Layers& layers, const shading::SceneData& scene, const CameraModel& camera, int width, int first, int last, bool antialias);

}  // namespace verisim::render
