// The fast noise for one instruction set, and the choice of it.
#pragma once

#include "tracer/simd/instruction_sets.h"
#include "tracer/noise/noise.h"

namespace verisim::textures {

// Points whose noise is asked for together; those that are not used are zero.
struct alignas(64) EightPoints {
  double x[8] = {}, y[8] = {}, z[8] = {};
};

// One entry a generator; entry 0 is unused.
struct NoiseKernels {
  const char* name;
  double (*noise[4])(const Vec3& p);
  // The noises at those of the points that are wanted, octaves of one point most of all: their cells are remembered.
  // The eight noises are aligned as points are.
  void (*noises[4])(const EightPoints& points, unsigned wanted, double* noises);
  double (*turbulence[4])(const Vec3& p, const Octaves& octaves);
  double (*granite[4])(const Vec3& p);
  double (*wrinkles[4])(const Vec3& p);
  Vec3 (*vector_noise)(const Vec3& p);
  Vec3 (*vector_turbulence)(const Vec3& p, const Octaves& octaves);
  Vec3 (*wrinkles_vector)(const Vec3& p);
};

// `set` must not be beyond best_instruction_set().
const NoiseKernels& noise_kernels(simd::InstructionSet set);

// At the points that are wanted (bit k: point k), bit by bit what noise() gives at each; the others are anything.
// `noises` is aligned as points are.
void noises(int generator, const EightPoints& points, unsigned wanted, double* noises);
// The first `count` of eight, as bits.
constexpr unsigned first_of_eight(int count) { return (1u << count) - 1; }

}  // namespace verisim::textures
