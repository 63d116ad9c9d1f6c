// The colour of one pixel sample: camera ray or lens rays, traced.
#pragma once

#include "tracer/render/camera_rays.h"
#include "tracer/render/focal_blur.h"
#include "tracer/render/mesh_camera.h"
#include "tracer/shading/tracer.h"

namespace verisim::render {

// What all threads share.
struct CameraModel {
  CameraModel(const scene::Camera& description, int width, int height, textures::Compiler& compiler);

  const scene::Camera& camera;
  CameraRays rays;
  std::optional<MeshCamera> mesh;
  std::optional<FocalBlur> blur;
  const textures::CompiledNormal* normal = nullptr;
  bool origin_varies = false;
};

// One per thread.
class PixelSampler {
 public:
  PixelSampler(const CameraModel& camera, shading::Tracer& tracer) : camera_(camera), tracer_(tracer) {}
  // (x, y): pixel position, centres at integers. A position without a ray is black with transmit 1.
  Color operator()(double x, double y);

 private:
  Color mesh_sample(double x, double y);
  Color trace(Ray ray, const Vec2& image);

  const CameraModel& camera_;
  shading::Tracer& tracer_;
};

}  // namespace verisim::render
