// Rays that are traced together, as arrays: what wide instructions work on.
#pragma once

#include <bit>

#include "tracer/math/vec.h"

namespace verisim {

// Wide instructions work on eight rays at a time: behind the last one stands any number.
struct alignas(64) RayBatch {
  static constexpr int kMax = 64, kStep = 8, kSize = kMax + kStep;  // a tile of camera rays (accel/coherent_rays.h)
  struct Vectors {
    double x[kSize], y[kSize], z[kSize];
    Vec3 at(int i) const { return {x[i], y[i], z[i]}; }
    void set(int i, const Vec3& v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
  };
  Vectors origin, direction;
  Ray at(int i) const { return {origin.at(i), direction.at(i)}; }
};

// Eight rays of a batch: lane k is ray first + k. Sets of lanes are bits.
struct RayPacket {
  static constexpr int kCount = RayBatch::kStep;
  const RayBatch& rays;
  int first;
  unsigned active;  // what other lanes hold means nothing
  Ray at(int lane) const { return rays.at(first + lane); }
};

template <class Visit>
void each_lane(unsigned lanes, Visit&& visit) {
  for (; lanes != 0; lanes &= lanes - 1) visit(std::countr_zero(lanes));
}

}  // namespace verisim
