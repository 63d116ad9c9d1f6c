#include "tracer/shapes/quadrics/plane_set.h"

namespace verisim::shapes {

PlaneSet::PlaneSet() : kernels_(plane_kernels()) {}

void PlaneSet::add(const Vec3& normal, double distance, bool inverted) {
  const int lane = count_ % 8;
  if (lane == 0) blocks_.emplace_back();
  EightPlanes& block = blocks_.back();
  block.x[lane] = normal.x, block.y[lane] = normal.y, block.z[lane] = normal.z, block.distance[lane] = distance;
  block.side[lane] = inverted ? -1 : 1;
  all_ |= std::uint64_t{1} << count_;
  if (!inverted) inside_ |= std::uint64_t{1} << count_;
  ++count_;
}

void PlaneSet::meet(const RayPacket& rays, Lanes& lanes, double* enter, double* leave) const {
  alignas(64) double doubt[RayPacket::kCount];
  for (int k = 0; k < RayPacket::kCount; ++k) doubt[k] = doubt_at(rays.rays.origin.at(rays.first + k));
  for (int i = 0; i < count_; ++i)
    lanes.met[i] = kernels_.meet_batch(blocks_[static_cast<std::size_t>(i / 8)], i % 8, rays.rays, rays.first, doubt,
                                       lanes.t[i], enter, leave);
}

}  // namespace verisim::shapes
