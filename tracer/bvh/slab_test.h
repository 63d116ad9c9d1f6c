// The boxes of objects as POV-Ray tests them.
#pragma once

#include <array>
#include <limits>

#include "tracer/scene/bounds.h"

namespace verisim::accel {

// POV-Ray's own test of an object's box, in single precision (spec 03 2.2; the order of comparisons is that of
// Williams, Barrus, Morley and Shirley, "An efficient and robust ray-box intersection algorithm", 2005). Only a ray
// that grazes the box can fail it and meet the object nevertheless: one that runs within a face across x does, because
// 0 times infinity is NaN there; within other faces it passes.
struct SlabTest {
  std::array<float, 3> low, high;
  bool used = false;

  // `before`: false, too, for boxes that begin as far away or farther.
  bool passes(const Ray& ray, float before = std::numeric_limits<float>::infinity()) const {
    if (!used) return true;
    float near[3], far[3];
    for (int i = 0; i < 3; ++i) {
      const auto inverse = static_cast<float>(1 / ray.direction[i]), origin = static_cast<float>(ray.origin[i]);
      const bool backward = inverse < 0;
      near[i] = ((backward ? high[i] : low[i]) - origin) * inverse;
      far[i] = ((backward ? low[i] : high[i]) - origin) * inverse;
    }
    for (int i = 1; i < 3; ++i) {
      if (near[0] > far[i] || near[i] > far[0]) return false;
      if (near[i] > near[0]) near[0] = near[i];
      if (far[i] < far[0]) far[0] = far[i];
    }
    return near[0] < before && far[0] > 1e-4f;
  }
};

// Boxes without end are not tested.
inline SlabTest slab_test(const scene::Bounds& box) {
  SlabTest slab;
  if (scene::volume(box) >= 7e30f) return slab;
  for (std::size_t k = 0; k < 3; ++k) slab.low[k] = box.low[k], slab.high[k] = box.low[k] + box.size[k];
  slab.used = true;
  return slab;
}

}  // namespace verisim::accel
