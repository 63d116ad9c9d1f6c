// Eight rays against the triangles of a mesh, compiled for several instruction sets: what one ray finds alone.
#pragma once

#include "tracer/shapes/mesh/mesh_geometry.h"
#include "tracer/shapes/packet_kernels.h"

namespace verisim::shapes {

// Eight rays in a mesh's space (Primitive::local) and what they meet.
struct alignas(64) MeshPacket {
  LocalPacket rays;
  double t[RayPacket::kCount];               // in the world
  std::int64_t triangle[RayPacket::kCount];  // of the tree's order; -1: none
  unsigned passed_over;                      // lanes that meet a triangle before t_min
  unsigned met_two;                          // lanes whose nearest is one of two in the same place
};

struct MeshKernels {
  // The nearest triangle (`any`: one) at t_min <= t < t_max[k], of equal ones the last written, for the lanes of
  // `active`; `entry` of a shaft that holds them, or null. With `any`, the sets of lanes may lack some that are hit.
  void (*meet)(const MeshGeometry& mesh, const accel::EntryPoints* entry, unsigned active, double t_min,
               const double* t_max, bool any, MeshPacket& packet);
  // A triangle of its own, in the world.
  void (*triangle)(const FlatTriangle<double>& triangle, PlaneAxes axes, const RayPacket& rays, double t_min,
                   const double* t_max, PacketHits& met);
};

// Those of the best instruction set of this machine.
const MeshKernels& mesh_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const MeshKernels* mesh_kernels(int instruction_set);

}  // namespace verisim::shapes
