// Which segments of a lathe eight rays may meet, and about where: Lathe solves those alone. Compiled for several
// instruction sets.
#pragma once

#include "tracer/math/bernstein_packet.h"
#include "tracer/shapes/packet_kernels.h"
#include "tracer/shapes/swept/plane_curve.h"

namespace verisim::shapes {

struct alignas(64) LathePacket {
  using Lane = double[RayPacket::kCount];
  LocalPacket rays;
  Lane r, m, c;  // the squared distance from the axis is r t^2 + 2 m t + c
};

// Eight segments of a profile: their heights and squared radii. Behind the last one of a profile stand segments that
// nothing meets.
struct alignas(64) EightSegments {
  using Lane = double[8];
  Lane y_low, y_high, low2, high2;
};
// One ray within the largest radius, between the distances near and far.
struct LathePassage {
  double y0, y1, slack;  // the heights that it passes
  // Its squared distance from the axis is (r t + 2 m) t + c, at t = (y - height) inverse: lowest at `turn`, known to
  // `doubt`. inverse 0: it is too level for that.
  double r, m, c, height, near, far, inverse = 0, turn = 0, doubt = 0;
};

struct LatheKernels {
  // The segments that a ray may meet; of the others it is known that it passes them within or around or at other
  // heights.
  unsigned (*along)(const EightSegments& segments, const LathePassage& ray);
  // The lanes of `active` that come within the squared distance `outer2` of the axis.
  unsigned (*begin)(double outer2, unsigned active, LathePacket& packet);
  // The polynomials of a segment, for rays that are not nearly horizontal.
  void (*follow)(const CurveSegment& segment, const LathePacket& packet, RootPacket& roots);
};

// Those of the best instruction set of this machine.
const LatheKernels& lathe_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const LatheKernels* lathe_kernels(int instruction_set);

}  // namespace verisim::shapes
