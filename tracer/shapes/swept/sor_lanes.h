// A surface of revolution along eight rays at once. Compiled for several instruction sets; every lane does what
// Sor::crossings does.
#pragma once

#include <array>

#include "tracer/math/bernstein_lanes.h"
#include "tracer/shapes/lane_kernels.h"

namespace verisim::shapes {

struct SorSegment {
  double low, high;              // heights
  std::array<double, 4> c;       // radius^2 = c[0] + c[1] y + c[2] y^2 + c[3] y^3
  double least2 = 0, most2 = 0;  // bounds of radius^2, a little wide
  double radius2(double y) const { return ((c[3] * y + c[2]) * y + c[1]) * y + c[0]; }
  double slope(double y) const { return (3 * c[3] * y + 2 * c[2]) * y + c[1]; }
};

struct alignas(64) SorLanes {
  using Lane = double[RayLanes::kCount];
  LocalLanes rays;
  Lane r, m, c;    // the squared distance from the axis is r t^2 + 2 m t + c
  Lane near, far;  // within the largest radius
  Lane upper;      // how far each ray may still go
  Lane from;       // where a ray enters a segment
};

struct SorKernels {
  // The lanes of `asked` that come within the squared distance `around2` of the axis.
  unsigned (*begin)(double around2, double farthest, unsigned asked, SorLanes& lanes);
  // The lanes of `asked` that may meet a segment, with their polynomials in powers of t - from; those for which it is
  // too far are taken from `asked`.
  unsigned (*enter)(const SorSegment& segment, unsigned& asked, SorLanes& lanes, RootLanes& roots);
};

// Those of the best instruction set of this machine.
const SorKernels& sor_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const SorKernels* sor_kernels(int instruction_set);

}  // namespace verisim::shapes
