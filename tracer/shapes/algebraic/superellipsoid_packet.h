// Newton's method from outside a convex superellipsoid, for eight rays at once. Compiled for several instruction sets;
// all give the same bits, and what one lane finds does not depend on the others.
#pragma once

#include "tracer/math/ray_batch.h"

namespace verisim::shapes {

// Rays in the shape's own space, and how far each may go.
struct alignas(64) ConvexPacket {
  static constexpr int kCount = RayPacket::kCount;
  double ox[kCount], oy[kCount], oz[kCount], dx[kCount], dy[kCount], dz[kCount];
  double t[kCount];      // where the search begins, outside; then the root
  double end[kCount];    // it goes no further than this
  double side[kCount];   // 1: forward, -1: backward
  double value[kCount];  // |(|(x, y)|_p, z)|_q - 1 at t, as an answer
  double slope[kCount];  // of the value
};

struct SuperellipsoidKernels {
  // From t towards `end`. The lanes of `active` that find the surface.
  unsigned (*approach)(double p, double q, unsigned active, ConvexPacket& packet);
  // The same for the first two lanes.
  unsigned (*approach_pair)(double p, double q, unsigned active, ConvexPacket& packet);
};

// Those of the best instruction set of this machine.
const SuperellipsoidKernels& superellipsoid_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const SuperellipsoidKernels* superellipsoid_kernels(int instruction_set);

}  // namespace verisim::shapes
