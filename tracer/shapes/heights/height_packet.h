// Eight rays over a height field together. Those that go the same way walk the pyramid of extremes as one thick ray,
// whose cells are tested against all of them. What they find is what HeightWalk and one test after another find alone.
// Compiled for several instruction sets.
#pragma once

#include "tracer/math/ray_batch.h"
#include "tracer/math/transform.h"
#include "tracer/shapes/heights/height_grid.h"

namespace verisim::shapes {

inline constexpr double kHeightFieldNearest = 1e-6, kHeightFieldEdge = 1e-4;

struct alignas(64) HeightPacket {
  static constexpr int kCount = RayPacket::kCount;
  using Lane = double[kCount];
  // Rays in grid units, and where they enter and leave the field's box.
  Lane ox, oy, oz, dx, dy, dz, enter, leave;
  // The nearest hits; triangle -1: none.
  Lane t;
  std::int64_t triangle[kCount], i[kCount], k[kCount];
};

struct HeightPacketKernels {
  // Sets the rays; the lanes that meet the box. `matrix`: from grid units.
  unsigned (*enter)(const HeightGrid& grid, const Transform& matrix, const RayPacket& rays, HeightPacket& packet);
  // Sets the hits of `lanes`, which agree in the signs of dx and dz, with t_min <= t < t_max; `any`: not the nearest,
  // but any. False: they do not make a thick ray, nothing is done.
  bool (*walk)(const HeightGrid& grid, unsigned lanes, double t_min, const double* t_max, bool any,
               HeightPacket& packet);
};

// Those of the best instruction set of this machine.
const HeightPacketKernels& height_packet_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const HeightPacketKernels* height_packet_kernels(int instruction_set);

}  // namespace verisim::shapes
