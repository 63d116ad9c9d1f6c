// Orbits of eight points of fractal patterns at once. Compiled for several instruction sets.
#pragma once

#include "tracer/scene/pattern.h"

namespace verisim::textures {

// Eight orbits; they start at z.
struct alignas(64) Orbits {
  double zr[8], zi[8], cr[8], ci[8];
  double smallest[8];  // squared size so far
  int k[8];            // of those that escaped: the iteration that did it
  int left[8];         // of the others: iterations that are left to do
};

struct OrbitKernels {
  // Follows the orbits of `active` until they escape, have come round, or for all iterations. Returns those that
  // escaped.
  unsigned (*follow)(int magnet, int exponent, int iterations, unsigned active, Orbits& orbits);
};

// Those of the best instruction set of this machine.
const OrbitKernels& orbit_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const OrbitKernels* orbit_kernels(int instruction_set);

// What `fractal` is at the first `count` points. Arrays of a multiple of eight.
void fractal_batch(const scene::FractalParams& f, scene::PatternKind kind, int count, const double* x, const double* y,
                   double* values, const OrbitKernels& kernels = orbit_kernels());

}  // namespace verisim::textures
