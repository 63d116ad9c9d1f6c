// Depth of field: where on the lens a sample's rays go, and when enough of them were traced (spec 02 section 2).
#pragma once

#include <functional>
#include <vector>

#include "tracer/render/camera_rays.h"

namespace verisim::render {

class FocalBlur {
 public:
  // Greyscale of the bokeh pigment at a point; empty without bokeh.
  using Weight = std::function<double(const Vec3&)>;
  FocalBlur(const scene::Camera& camera, const Weight& bokeh);

  // The n-th lens ray of the pixel sample at (x, y); its direction is unit. Empty where the camera has no ray.
  std::optional<PrimaryRay> ray(const CameraRays& camera, double x, double y, int n) const;

  // Averages `trace(ray)` over lens rays until the statistical test is satisfied. `trace` gets an empty ray where there is none.
  template <class Trace>
  Color sample(const CameraRays& camera, double x, double y, Trace&& trace) const {
    Color sum;
    float squares[4] = {};
    float no_ray_transmit = 0;
    int n = 0;
    for (const Group& group : groups_) {
      for (; n < group.end; ++n) {
        const std::optional<PrimaryRay> primary = ray(camera, x, y, n);
        const Color c = primary ? trace(*primary, n) : Color();
        const float t = primary ? c.t : 1.0f;  // a missing ray is opaque in the sum, clear in the test
        if (!primary) no_ray_transmit += 1.0f;
        sum += c;
        squares[0] += c.r * c.r, squares[1] += c.g * c.g, squares[2] += c.b * c.b, squares[3] += t * t;
      }
      if (n >= minimum_ && group.threshold > 0) {
        const float sums[4] = {sum.r, sum.g, sum.b, sum.t + no_ray_transmit};
        bool settled = true;
        for (int c = 0; c < 4; ++c) {
          const double mean = static_cast<double>(sums[c]) / n;
          settled = settled && static_cast<float>((static_cast<double>(squares[c]) / n - mean * mean) / n) < group.threshold;
        }
        if (settled) break;
      }
    }
    const auto count = static_cast<float>(n);
    return {sum.r / count, sum.g / count, sum.b / count, sum.f / count, sum.t / count};
  }

  const std::vector<Vec2>& positions() const { return positions_; }
  double lens_jitter() const { return lens_jitter_; }

 private:
  struct Group {
    int end;          // number of rays after this group
    float threshold;  // of the variance of the mean
  };
  void place_without_bokeh(int count);
  void place_by_bokeh(int count, const Weight& weight);
  void make_groups(const scene::Camera& camera, const std::vector<int>& sizes);

  std::vector<Vec2> positions_;
  std::vector<Group> groups_;
  double lens_jitter_ = 0;
  int minimum_;
  double aperture_, focal_scale_;  // focal distance over the length of the direction
  Vec3 location_, lens_x_, lens_y_;
};

}  // namespace verisim::render
