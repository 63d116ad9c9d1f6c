// The boxes of a tree that a ray meets, found once: for rays that are followed from surface to surface, which would
// walk through the tree anew for each.
#pragma once

#include <cstdint>
#include <span>

#include <boost/container/static_vector.hpp>

namespace verisim::accel {

class BoxesAlong {
 public:
  struct Met {
    float near, far;  // from where the ray enters the tree; the box reaches no farther
    std::uint32_t primitive;
  };
  // Room for more would be longer in use than walks that end at the first surface.
  static constexpr int kMax = 64;

  // Nearest first.
  std::span<const Met> all() const { return {met_.data(), met_.size()}; }
  // Where the ray enters the tree, from its origin.
  double start() const { return start_; }

  void begin(double start) { met_.clear(), start_ = start; }
  // False: there is no room.
  bool add(const Met& added) {
    if (met_.size() == kMax) return false;
    auto place = met_.insert(met_.end(), added);
    for (; place != met_.begin() && place[-1].near > added.near; --place) *place = place[-1];
    *place = added;
    return true;
  }

 private:
  boost::container::static_vector<Met, kMax> met_;
  double start_ = 0;
};

}  // namespace verisim::accel
