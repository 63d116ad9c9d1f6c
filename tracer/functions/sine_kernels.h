// Sines and cosines of many angles, with the bits of the C library. Compiled for several instruction sets.
#pragma once

namespace verisim::functions {

struct SineKernels {
  // Of `count` angles; the arrays are apart.
  void (*sines_and_cosines)(const double* angles, int count, double* sines, double* cosines);
};

// Those of the best instruction set of this machine.
const SineKernels& sine_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const SineKernels* sine_kernels(int instruction_set);

}  // namespace verisim::functions
