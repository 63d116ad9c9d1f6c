// mesh_camera: one ray from every face of a mesh (spec 02 section 1.7).
#pragma once

#include <array>
#include <optional>

#include "tracer/bvh/bvh.h"
#include "tracer/scene/camera.h"
#include "tracer/scene/object.h"

namespace verisim::render {

class MeshCamera {
 public:
  MeshCamera(const scene::Camera& camera, int width, int height, int left, int top);
  int rays_per_pixel() const { return camera_.rays_per_pixel; }
  // Ray number k of the sample at (x, y), direction unit; empty: no face.
  std::optional<Ray> ray(double x, double y, int k) const;
  // That of the first pixel, in the order of blocks, that has one.
  std::optional<Ray> first_ray() const;

 private:
  struct Face {
    std::size_t mesh;
    std::size_t triangle;
  };
  std::optional<Face> face(double x, double y, int k) const;
  Ray finished(std::size_t mesh, const Vec3& origin, const Vec3& normal) const;
  std::optional<Ray> by_uv(const Vec2& uv) const;
  // The first triangle around a point of the UV map, and the point's weights in it.
  struct UvPlace {
    std::uint32_t triangle;
    std::array<int, 3> corners;  // in the order in which POV-Ray keeps them
    double weights[3];           // of these
  };
  std::optional<UvPlace> uv_place(const Vec2& uv, double tolerance) const;

  const scene::Camera& camera_;
  int width_, height_, left_, top_;  // of the whole picture; where the window lies in it
  accel::Bvh uv_map_;                // of the first mesh's triangles, for distribution 3
};

}  // namespace verisim::render
