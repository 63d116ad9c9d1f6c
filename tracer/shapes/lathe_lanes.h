// A lathe along eight rays at once. Compiled for several instruction sets; every lane does what Lathe::crossings does.
#pragma once

#include "tracer/math/bernstein_lanes.h"
#include "tracer/shapes/lane_kernels.h"
#include "tracer/shapes/plane_curve.h"

namespace verisim::shapes {

struct alignas(64) LatheLanes {
  using Lane = double[RayLanes::kCount];
  LocalLanes rays;
  Lane r, m, c;  // the squared distance from the axis is r t^2 + 2 m t + c
  Lane y0, y1;   // the heights that a ray passes within the largest radius
};

struct LatheKernels {
  // The lanes of `asked` that come within the squared distance `outer2` of the axis.
  unsigned (*begin)(double outer2, unsigned asked, LatheLanes& lanes);
  // The lanes that pass the heights of a segment.
  unsigned (*beside)(double low, double high, double slack, const LatheLanes& lanes);
  // The polynomials of a segment, for rays that are not nearly horizontal.
  void (*follow)(const CurveSegment& segment, const LatheLanes& lanes, RootLanes& roots);
};

// Those of the best instruction set of this machine.
const LatheKernels& lathe_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const LatheKernels* lathe_kernels(int instruction_set);

}  // namespace verisim::shapes
