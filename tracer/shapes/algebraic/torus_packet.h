// The quartics of a torus along eight rays (torus_quartic.inc). Compiled for several instruction sets.
#pragma once

#include "tracer/shapes/packet_kernels.h"

namespace verisim::shapes {

// Quartics along rays in a torus's own space, and where they count from.
struct alignas(64) TorusPacket {
  unsigned met;                    // lanes that come near; of others the rest means nothing
  double c[4][RayPacket::kCount];  // after the leading 1
  double advance[RayPacket::kCount], scale[RayPacket::kCount];
};

// `matrix`: from the torus's own space.
using TorusQuartic = void (*)(double major, double minor, const Transform* matrix, const RayPacket& rays,
                              TorusPacket& packet);

const TorusQuartic& torus_quartic_kernel();
// That of any set, for tests; null: this machine cannot run it.
const TorusQuartic* torus_quartic_kernel(int instruction_set);

}  // namespace verisim::shapes
