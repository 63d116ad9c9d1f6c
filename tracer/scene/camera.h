// The camera after all items were applied in POV-Ray's order (spec 02 section 1).
#pragma once

#include "tracer/scene/texture.h"

namespace verisim::scene {

struct MeshData;

enum class CameraKind : std::uint8_t {
  perspective,
  orthographic,
  fisheye,
  ultra_wide_angle,
  omnimax,
  panoramic,
  cylinder1,
  cylinder2,
  cylinder3,
  cylinder4,
  spherical,
  mesh_camera
};

struct Camera {
  CameraKind kind = CameraKind::perspective;
  Vec3 location{0, 0, 0}, direction{0, 0, 1}, up{0, 1, 0}, right{1.33, 0, 0}, sky{0, 1, 0}, look_at{0, 0, 1};
  double angle = 90;                                    // degrees; fisheye, ultra_wide_angle, cylinder
  double horizontal_angle = 360, vertical_angle = 180;  // spherical
  double aperture = 0, focal_distance = 1;
  int blur_samples = 0, blur_samples_min = 0;
  double confidence = 0.9, variance = 1.0 / 10000;
  PigmentPtr bokeh;
  NormalPtr normal;
  // mesh_camera
  int rays_per_pixel = 1, distribution = 0;
  double max_distance = 0;
  bool smooth = false;
  std::vector<std::shared_ptr<const MeshData>> meshes;
  std::vector<Transform> mesh_transforms;
};

}  // namespace verisim::scene
