// Primary rays of every camera type (spec 02 sections 1.5 to 1.7).
#pragma once

#include <memory>
#include <optional>

#include "tracer/math/perspective.h"
#include "tracer/scene/camera.h"
#include "tracer/shading/wavefront/wavefront_kernels.h"
#include "tracer/textures/texture.h"

namespace verisim::render {

// A primary ray before normalisation, with the camera's own image coordinates (what camera normals are evaluated at).
struct PrimaryRay {
  Ray ray;
  Vec2 image;
};

// Where what is rendered lies in a larger picture, by its top left pixel.
struct WindowPlace {
  int left = 0, top = 0;
};

// All cameras but mesh_camera, for a picture of width by height or a window of it. (x, y) is a fractional pixel
// position; a pixel's centre has integer coordinates.
class CameraRays {
 public:
  CameraRays(const scene::Camera& camera, int width, int height, WindowPlace window = {});
  // Empty: no ray belongs to this position (outside a fisheye's disc ...).
  std::optional<PrimaryRay> at(double x, double y) const;
  // The unit directions of the rays of a perspective camera through places of the picture; behind them is room up to a
  // multiple of RayBatch::kStep.
  void directions(const Vec2* places, int count, shading::WavefrontPacket& packet) const {
    shading::wavefront_kernels().directions(view_, places, count, packet);
  }
  // Null: it is not a perspective camera.
  const PerspectiveView* perspective() const { return kind_ == scene::CameraKind::perspective ? &view_ : nullptr; }
  // Rays start at different points, so the objects around the origin must be looked up for each (spec 02 section 1.8).
  bool origin_varies() const { return origin_varies_; }

 private:
  std::optional<PrimaryRay> fisheye(double p, double q) const;
  // phi: around the direction, from the right; theta: from the direction.
  PrimaryRay round_ray(double phi, double theta) const;
  std::optional<PrimaryRay> omnimax(double u2, double w2) const;

  scene::CameraKind kind_;
  PerspectiveView view_;
  Vec3 location_;
  Vec3 unit_direction_, unit_right_, unit_up_;
  double right_length_, up_length_;
  double angle_;                  // degrees
  double horizontal_, vertical_;  // radians
  bool origin_varies_;
};

// Perturbs a unit primary direction by the camera's normal (spec 02 section 1.6).
Vec3 perturb_direction(const textures::CompiledNormal& normal, const Vec3& unit_direction, const Vec2& image);

}  // namespace verisim::render
