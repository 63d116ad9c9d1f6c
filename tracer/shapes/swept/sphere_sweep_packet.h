// The side of a curved segment of a sphere_sweep along eight rays at once. Compiled for several instruction sets.
#pragma once

#include "tracer/shapes/packet_kernels.h"

namespace verisim::shapes {

// Centre and radius of a moving sphere in powers of its parameter, and its centre half way.
struct SweepCubic {
  double power[4][4], middle[3];
};

struct alignas(64) SweepSidePacket {
  using Lane = double[RayPacket::kCount];
  Lane power[11];
};

using SweepFollow = void (*)(const SweepCubic& cubic, const LocalPacket& rays, SweepSidePacket& packet);

// That of the best instruction set of this machine.
const SweepFollow& sweep_follow();
// That of any set, for tests; null: this machine cannot run it.
const SweepFollow* sweep_follow(int instruction_set);

}  // namespace verisim::shapes
