// The fast noise for one instruction set, and the choice of it.
#pragma once

#include "tracer/textures/instruction_sets.h"
#include "tracer/textures/noise.h"

namespace verisim::textures {

// One entry a generator; entry 0 is unused.
struct NoiseKernels {
  const char* name;
  double (*noise[4])(const Vec3& p);
  double (*turbulence[4])(const Vec3& p, const Octaves& octaves);
  double (*granite[4])(const Vec3& p);
  double (*wrinkles[4])(const Vec3& p);
  Vec3 (*vector_noise)(const Vec3& p);
  Vec3 (*vector_turbulence)(const Vec3& p, const Octaves& octaves);
  Vec3 (*wrinkles_vector)(const Vec3& p);
};

// `set` must not be beyond best_instruction_set().
const NoiseKernels& noise_kernels(InstructionSet set);

}  // namespace verisim::textures
