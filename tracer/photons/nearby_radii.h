// How far the photons that are nearest to a point reach, judged by what was found nearby.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tracer/math/vec.h"

namespace verisim::global {

// What one thread remembers of searches in one map. Points that are searched from lie close together when a picture is
// fine, or where a ray goes through media: the radius that was enough nearby is enough here, if it is as much larger as
// the point is farther away.
class NearbyRadii {
 public:
  struct Known {
    Vec3 point{0.0};
    double radius = 0;  // 0: nothing known
    // More than that are to be looked at again if it is too little, which is cheaper than to be sure.
    double enough(const Vec3& p) const {
      return radius > 0.0 ? std::min(radius * (1.0 + 1e-9) + length(p - point), 1.1 * radius) : 0.0;
    }
  };
  // What is known around p, in a cell of space a good deal smaller than a search may reach, and in one smaller than
  // they reached there, which may be much less.
  struct Places {
    Known &around, &near;
    const Known& nearest(const Vec3& p) const {
      return near.radius > 0.0 && length(near.point - p) < length(around.point - p) ? near : around;
    }
    void remember(const Known& known) const { around = near = known; }
  };
  // For searches within `radius`.
  Places at(const Vec3& p, double radius);

 private:
  static constexpr std::size_t kPlaces = 512;
  Known& cell(std::vector<Known>& cells, const Vec3& p, double side);

  std::vector<Known> large_, small_;
  Known nowhere_;
};

}  // namespace verisim::global
