// POV-Ray's memory of the last search for an isosurface that found nothing (spec 04 6.3): near to it a search is not
// made at all. With too small a max_gradient that loses hits, so what is seen hangs on the order of rays; it counts
// only where rays are traced in POV-Ray's order.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "tracer/math/vec.h"

namespace verisim::shapes {

struct LastMiss {
  bool kept = false;        // searches read and write it
  bool shadow_ray = false;  // which only reads it
  std::uint64_t isosurface = 0;
  double ends[6] = {};  // of the search: the points where it begins and ends, in the isosurface's space
  double least = 0;     // of the values seen, with the sign that was looked for

  bool spares(std::uint64_t which, const Vec3& from, const Vec3& to, double max_gradient) const {
    if (which != isosurface) return false;
    const Vec3 begin(ends[0], ends[1], ends[2]), end(ends[3], ends[4], ends[5]);
    return least - max_gradient * std::max(length(from - begin), length(to - end)) > 0;
  }
  void keep(std::uint64_t which, const Vec3& from, const Vec3& to, double least_value) {
    *this = {kept, shadow_ray, which, {from.x, from.y, from.z, to.x, to.y, to.z}, least_value};
  }
};

// This thread's.
LastMiss& last_miss();

// While it lives, this thread's rays are shadow rays.
class ShadowRays {
 public:
  ShadowRays() : before_(last_miss().shadow_ray) { last_miss().shadow_ray = true; }
  ~ShadowRays() { last_miss().shadow_ray = before_; }
  ShadowRays(const ShadowRays&) = delete;
  ShadowRays& operator=(const ShadowRays&) = delete;

 private:
  const bool before_;
};

}  // namespace verisim::shapes
