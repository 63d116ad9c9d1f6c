// Primary rays of every camera type (spec 02 sections 1.5 to 1.7).
#pragma once

#include <memory>
#include <optional>

#include "tracer/render/cameras/lens_kernels.h"
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
    if (left_ != 0 || top_ != 0) return window_directions(places, count, packet);
    shading::wavefront_kernels().directions({width_, height_, direction_, right_, up_}, places, count, packet);
  }
  // The parts of a perspective camera; empty: it is another one.
  std::optional<LensCamera> perspective() const;
  // Rays start at different points, so the objects around the origin must be looked up for each (spec 02 section 1.8).
  bool origin_varies() const { return origin_varies_; }

 private:
  void window_directions(const Vec2* places, int count, shading::WavefrontPacket& packet) const;
  std::optional<PrimaryRay> fisheye(double p, double q) const;
  // phi: around the direction, from the right; theta: from the direction.
  PrimaryRay round_ray(double phi, double theta) const;
  std::optional<PrimaryRay> omnimax(double u2, double w2) const;

  scene::CameraKind kind_;
  double width_, height_, left_, top_;
  Vec3 location_, direction_, right_, up_;
  Vec3 unit_direction_, unit_right_, unit_up_;
  double right_length_, up_length_;
  double angle_;                  // degrees
  double horizontal_, vertical_;  // radians
  bool origin_varies_;
};

// Perturbs a unit primary direction by the camera's normal (spec 02 section 1.6).
Vec3 perturb_direction(const textures::CompiledNormal& normal, const Vec3& unit_direction, const Vec2& image);

}  // namespace verisim::render
