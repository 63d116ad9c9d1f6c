// The colour of one pixel sample: camera ray or lens rays, traced.
#pragma once

#include <span>

#include "tracer/render/cameras/camera_rays.h"
#include "tracer/render/sampling/focal_blur.h"
#include "tracer/render/cameras/mesh_camera.h"
#include "tracer/shading/wavefront/wavefront.h"

namespace verisim::render {

// What all threads share.
struct CameraModel {
  // Of a picture of width by height, or a window of it.
  CameraModel(const scene::Camera& description, int width, int height, textures::Compiler& compiler,
              WindowPlace window = {});

  const scene::Camera& camera;
  CameraRays rays;
  std::optional<MeshCamera> mesh;
  std::optional<FocalBlur> blur;
  const textures::CompiledNormal* normal = nullptr;
  bool origin_varies = false;
  accel::CameraCoherence coherence;
  bool linear = false;  // rays are linear in the position: perspective and orthographic cameras without a normal
  // Neither neighbours nor places say where a ray goes (fisheye ..., mesh_camera, cameras with a normal): each is asked
  // for.
  bool free() const { return !linear && !blur; }
  int rays_per_sample() const { return mesh ? mesh->rays_per_pixel() : 1; }
  // The ray of a position, without focal blur: a unit direction, bent by the camera's normal; of a mesh camera its
  // `number`-th. Empty: there is none.
  std::optional<Ray> ray(double x, double y, int number = 0) const;
  // A ray of unit direction, bent by the camera's normal.
  Ray bent(Ray ray, const Vec2& image) const {
    if (normal) ray.direction = perturb_direction(*normal, ray.direction, image);
    return ray;
  }
  // How far camera rays go.
  double limit() const;
  // The shaft of all rays of a rectangle of the picture, for linear cameras, through a world with these bounds.
  std::optional<accel::Shaft> shaft(const Box3& world, double left, double top, double right, double bottom) const;

 private:
  void find_coherence(int width, int height);
};

// One per thread.
class PixelSampler {
 public:
  PixelSampler(const CameraModel& camera, shading::Tracer& tracer);
  // (x, y): pixel position, centres at integers. A position without a ray is black with transmit 1.
  Color operator()(double x, double y);
  // The colours at (x, y), (x + 1, y) ...: the same as one by one, but faster.
  void row(double x, double y, int count, Color* colors);
  // The colours at any places, best near each other: the same as one by one, but faster.
  void points(const Vec2* places, int count, Color* colors);
  // Samples may be asked for in any order; if not, random numbers would be drawn in another one.
  bool any_order() const { return !tracer_.in_order(); }

 private:
  bool together() const { return (camera_.linear || camera_.free()) && wavefront_.usable(); }
  // The colours at the wavefront's places: linear cameras with a lens, cameras that are not linear.
  void other_points(int count, Color* colors);
  static int near_each_other(const Vec2* places, int count);
  bool aim(int count);
  // Ray i of the wavefront starts within the same objects as ray 0, which is to be asked for first.
  bool starts_like_the_first(int i);
  // The colours at the wavefront's places; of a row, each is one pixel from the other.
  void batch_wavefront(int count, Color* colors);
  void point_wavefront(int count, Color* colors);
  void one_by_one(int count, Color* colors);
  // Where rays through (x, y), (x + 1, y) ... enter the world, `count` of them at most; sets it to the number of those
  // that this holds for.
  const accel::WorldEntry* entry(double x, double y, int& count);

  // ---- lens_samples.cpp
  struct LensRay {
    int sample, number;
  };
  std::optional<Color> lens_ray(const Vec2& place, int number, bool& hollow);
  Color lens_sample(const Vec2& place);
  void lens_points(int count, Color* colors);
  void lens_wavefront(std::span<const LensRay> rays);

  // ---- free_samples.cpp
  struct FreeRay {
    Ray ray;
    int sample, number;
  };
  Color free_sample(const Vec2& place);
  void free_points(int count, Color* colors);
  void free_wavefront(std::span<const FreeRay> rays, const Vec2* places, Color* sums);

  const CameraModel& camera_;
  shading::Tracer& tracer_;
  bool starts_differ_;  // rays may start within different objects
  shading::Wavefront wavefront_;
  std::vector<const scene::Interior*> around_;  // the wavefront's first ray, where rays start at different points
  // The samples that are taken together, and the rays that they wait for.
  struct Lens {
    Vec2 places[shading::Wavefront::kMax];
    const accel::WorldEntry* entries[shading::Wavefront::kMax];
    bool hollow[shading::Wavefront::kMax];  // none of its rays so far started in something that is not
    std::vector<FocalBlur::Average> averages;
    std::vector<LensRay> rays;
  } lens_;
};

}  // namespace verisim::render
