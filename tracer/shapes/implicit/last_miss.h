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
  // One that found nothing.
  struct Search {
    std::uint64_t isosurface = 0;
    double ends[6] = {};  // the points where it begins and ends, in the isosurface's space
    double least = 0;     // of the values seen, with the sign that was looked for
  };
  bool kept = false;        // searches read and write it
  bool shadow_ray = false;  // which only reads it
  Search last;

  bool spares(std::uint64_t which, const Vec3& from, const Vec3& to, double max_gradient) const {
    if (which != last.isosurface) return false;
    const double* const e = last.ends;
    const Vec3 begin(e[0], e[1], e[2]), end(e[3], e[4], e[5]);
    return last.least - max_gradient * std::max(length(from - begin), length(to - end)) > 0;
  }
  void forget() { last.isosurface = 0; }
  void keep(std::uint64_t which, const Vec3& from, const Vec3& to, double least_value) {
    last = {which, {from.x, from.y, from.z, to.x, to.y, to.z}, least_value};
  }
};

// This thread's.
LastMiss& last_miss();
void exchange_last_miss(LastMiss::Search& other);

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
