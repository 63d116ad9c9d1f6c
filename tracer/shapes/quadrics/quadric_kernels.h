// Eight rays against a sphere, box, cone or quadric. Compiled for several instruction sets, by the formulas of the
// shapes' own `intersections`; every lane finds what NearestHit would keep.
#pragma once

#include "tracer/shapes/packet_kernels.h"

namespace verisim::shapes {

// `matrix`: from the shape's own space, null: none. Eight limits stand at t_max.
struct QuadricKernels {
  void (*sphere)(const Vec3& center, double radius2, const Transform* matrix, const RayPacket& rays, double t_min,
                 const double* t_max, PacketHits& met);
  void (*box)(const SimpleSolid& solid, const RayPacket& rays, double t_min, const double* t_max, PacketHits& met);
  void (*cone)(bool cylinder, bool open, double narrow, const Transform* matrix, const RayPacket& rays, double t_min,
               const double* t_max, PacketHits& met);
  void (*quadric)(const scene::Quadric& quadric, const RayPacket& rays, double t_min, const double* t_max,
                  PacketHits& met);
};

const QuadricKernels& quadric_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const QuadricKernels* quadric_kernels(int instruction_set);

}  // namespace verisim::shapes
