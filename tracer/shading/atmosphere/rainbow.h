// Rainbows (spec 06 section 11.6).
#pragma once

#include <functional>
#include <vector>

#include "tracer/math/vec.h"
#include "tracer/scene/scene.h"

namespace verisim::shading {

class Rainbow {
 public:
  explicit Rainbow(const scene::Rainbow& description);
  bool active() const { return active_; }
  // What the bow shows in direction d over a segment: false if nothing. `random` yields numbers in [0, 1) for jitter.
  struct Effect {
    float keep;  // of the light behind
    Rgb filter;  // per channel on what is kept
    Rgb added;
    float see_through;
  };
  bool effect(const Vec3& d, double length, const std::function<double()>& random, Effect& out) const;

 private:
  Color color_at(double index) const;

  scene::Rainbow description_;
  bool active_ = false;
  Vec3 antisolar_, right_, up_;
  double angle_ = 0, width_ = 0, half_arc_ = 0, half_falloff_ = 0;  // radians
};

}  // namespace verisim::shading
