// Eight rays against one shape: what shapes with kernels share.
#pragma once

#include <cstdint>

#include "tracer/math/ray_batch.h"
#include "tracer/math/transform.h"
#include "tracer/shapes/shape.h"

namespace verisim::shapes {

struct alignas(64) PacketHits {
  double t[RayPacket::kCount];
  double local[RayPacket::kCount];       // the distance in the shape's own space, if the shape uses it
  std::int64_t part[RayPacket::kCount];  // -1: not hit
};

// Primitive::local of eight rays.
struct alignas(64) LocalPacket {
  double ox[RayPacket::kCount], oy[RayPacket::kCount], oz[RayPacket::kCount], dx[RayPacket::kCount],
      dy[RayPacket::kCount], dz[RayPacket::kCount];
  double scale[RayPacket::kCount];
};

// `matrix`: from the shape's own space, null: none.
struct PacketKernels {
  void (*local)(const Transform* matrix, const RayPacket& rays, LocalPacket& lanes);
};

// Those of the best instruction set of this machine.
const PacketKernels& packet_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const PacketKernels* packet_kernels(int instruction_set);

// Objects with clips and bounds of their own ask one ray after another.
inline bool has_guards(const scene::Object& o) { return !o.bounded_by.empty() || !o.clipped_by.empty(); }

// The lanes that are hit, with point_at(lane, ray) as their points.
template <class PointAt>
unsigned take_hits(const PacketHits& met, const RayPacket& rays, const Shape& shape, Hit* hits, PointAt&& point_at) {
  unsigned found = 0;
  each_lane(rays.active, [&](int k) {
    if (met.part[k] < 0) return;
    hits[k] = {met.t[k], point_at(k, rays.at(k)), &shape, static_cast<std::int32_t>(met.part[k]), 0, 0};
    found |= 1u << k;
  });
  return found;
}
inline unsigned packet_hits(const PacketHits& met, const RayPacket& rays) {
  unsigned found = 0;
  for (int k = 0; k < RayPacket::kCount; ++k) found |= met.part[k] >= 0 ? 1u << k : 0;
  return found & rays.active;
}

}  // namespace verisim::shapes
