// Depth of field: where on the lens a sample's rays go, and when enough of them were traced (spec 02 section 2).
#pragma once

#include <functional>
#include <vector>

#include "tracer/bvh/shaft.h"
#include "tracer/render/cameras/camera_rays.h"
#include "tracer/render/cameras/lens_kernels.h"

namespace verisim::render {

class FocalBlur {
 public:
  // Greyscale of the bokeh pigment at a point; empty without bokeh.
  using Weight = std::function<double(const Vec3&)>;
  FocalBlur(const scene::Camera& camera, const Weight& bokeh);

  // The n-th lens ray of the pixel sample at (x, y); its direction is unit. Empty where the camera has no ray.
  std::optional<PrimaryRay> ray(const CameraRays& camera, double x, double y, int n) const;
  // The same of lens rays numbers[i] of the samples at places[i], for cameras that have them all.
  void rays(const CameraRays& camera, const Vec2* places, const std::uint32_t* numbers, int count,
            RayBatch& rays) const;

  // What is known of a pixel sample: its lens rays are added in order, group by group, until the statistical test is
  // satisfied.
  class Average {
   public:
    explicit Average(const FocalBlur& blur) : blur_(&blur) {}
    bool complete() const { return complete_; }
    int known() const { return n_; }
    // How many rays there are to be before the next test.
    int wanted() const { return blur_->groups_[group_].end; }
    // Empty: the camera has no such ray.
    void add(const std::optional<Color>& seen);
    Color mean() const;

   private:
    void test();

    const FocalBlur* blur_;
    Color sum_;
    float squares_[4] = {};
    float no_ray_transmit_ = 0;
    int n_ = 0;
    std::size_t group_ = 0;
    bool complete_ = false;
  };
  // Where the lens rays of all pixel samples in a rectangle are, for a camera whose rays are linear in the position,
  // through a world with these bounds.
  std::optional<accel::Shaft> shaft(const CameraRays& camera, const Box3& world, double left, double top, double right,
                                    double bottom) const;

  // Where all lens rays start.
  Box3 lens() const;
  const std::vector<Vec2>& positions() const { return positions_; }
  double lens_jitter() const { return lens_jitter_; }

 private:
  struct Group {
    int end;          // number of rays after this group
    float threshold;  // of the variance of the mean
  };
  // Where a lens ray goes through the picture, and through the lens.
  struct Points {
    Vec2 picture, lens;
  };
  Points points(double x, double y, int n) const;
  void place_without_bokeh(int count);
  void place_by_bokeh(int count, const Weight& weight);
  void make_groups(const scene::Camera& camera, const std::vector<int>& sizes);

  std::vector<Vec2> positions_;
  std::vector<Group> groups_;
  double lens_jitter_ = 0;
  int minimum_;
  double aperture_;
  Lens lens_;
  Vec2 lens_extent_{0, 0};  // no ray starts further from the centre, along either axis
};

}  // namespace verisim::render
