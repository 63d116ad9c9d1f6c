#include "tracer/shapes/julia_row.h"

#include <algorithm>

#include "tracer/math/ray_row.h"

namespace verisim::shapes::julia {
namespace {

// All rays evaluate one point at a time, whatever they are about: the first point, a step, or a halving.
class Row {
 public:
  Row(const Field& field, const Stretch& stretch, unsigned asked, double* depth) : field_(field), stretch_(stretch), depth_(depth), active_(asked), first_(asked) {
    std::copy_n(stretch.begin, kLanes, at_);
  }

  unsigned run(const Rays& rays) {
    while (active_ != 0) {
      const unsigned inside = march_rays(field_, rays, at_, active_, active_ & ~halving_, estimate_);
      each_lane(active_, [&](int k) { advance(k, inside >> k & 1); });
    }
    return found_;
  }

 private:
  void advance(int k, bool now) {
    const unsigned lane = 1u << k;
    if (halving_ & lane) {
      if (now == was_in(k)) base_[k] = at_[k];
      halve(k);
    } else if (first_ & lane) {
      first_ &= ~lane;
      if (!now) return step(k);
      in_ |= lane;
      again_ |= lane;
      at_[k] += 2 * kFine;
      if (at_[k] > stretch_.end[k]) drop(k);
    } else if (again_ & lane) {
      again_ &= ~lane;
      if (!now) in_ &= ~lane;
      step(k);
    } else if (now == was_in(k)) {
      step(k);
    } else {
      halving_ |= lane;
      halve(k);
    }
  }

  bool was_in(int k) const { return in_ >> k & 1; }
  void drop(int k) { active_ &= ~(1u << k); }

  void step(int k) {
    base_[k] = at_[k], width_[k] = std::max(estimate_[k], field_.precision);
    at_[k] += width_[k];
    if (!(base_[k] <= stretch_.last[k] && base_[k] <= stretch_.limit[k] && at_[k] <= stretch_.end[k])) drop(k);
  }

  // The state changes between base and base + width.
  void halve(int k) {
    if (width_[k] > kFine) {
      width_[k] /= 2;
      at_[k] = base_[k] + width_[k];
      return;
    }
    depth_[k] = was_in(k) ? base_[k] : base_[k] + width_[k];
    found_ |= 1u << k;
    drop(k);
  }

  const Field& field_;
  const Stretch& stretch_;
  double* const depth_;
  unsigned active_, first_, again_ = 0, halving_ = 0, in_ = 0, found_ = 0;
  alignas(64) double at_[kLanes], base_[kLanes], width_[kLanes], estimate_[kLanes];
};

}  // namespace

unsigned first_crossings(const Field& field, const Rays& rays, const Stretch& stretch, unsigned asked, double depth[kLanes]) {
  return Row(field, stretch, asked, depth).run(rays);
}

}  // namespace verisim::shapes::julia
