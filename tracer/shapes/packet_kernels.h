// Eight rays against one simple shape. Compiled for several instruction sets; every lane does the operations of the
// shape's own `intersections` in the same order, and finds what NearestHit would keep.
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

// Quartics along rays in a torus's own space, and where they count from.
struct alignas(64) TorusPacket {
  std::int64_t met[RayPacket::kCount];  // 0: the ray does not come near
  double c[4][RayPacket::kCount];       // after the leading 1
  double advance[RayPacket::kCount], scale[RayPacket::kCount];
};

// `matrix`: from the shape's own space, null: none. Eight limits stand at t_max.
struct PacketKernels {
  void (*local)(const Transform* matrix, const RayPacket& rays, LocalPacket& lanes);
  void (*sphere)(const Vec3& center, double radius2, const Transform* matrix, const RayPacket& rays, double t_min,
                 const double* t_max, PacketHits& met);
  void (*box)(const SimpleSolid& solid, const RayPacket& rays, double t_min, const double* t_max, PacketHits& met);
  void (*cone)(bool cylinder, bool open, double narrow, const Transform* matrix, const RayPacket& rays, double t_min,
               const double* t_max, PacketHits& met);
  void (*torus)(double major, double minor, const Transform* matrix, const RayPacket& rays, TorusPacket& lanes);
  void (*quadric)(const scene::Quadric& quadric, const RayPacket& rays, double t_min, const double* t_max,
                  PacketHits& met);
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
