// The evaluation of patterns and pigments for one instruction set.
#pragma once

#include "tracer/simd/instruction_sets.h"
#include "tracer/textures/evaluation/pigment.h"
#include "tracer/textures/point_batch.h"

namespace verisim::textures {

struct EvaluationKernels {
  Vec3 (*warped)(const CompiledPattern& pattern, const Vec3& p);
  double (*value_at)(const CompiledPattern& pattern, const Vec3& warped_point, const SurfacePoint* surface);
  PatternValue (*value_of)(const CompiledPattern& pattern, const Vec3& p, const SurfacePoint* surface);
  bool (*evaluate)(const CompiledPigment& pigment, const Vec3& p, const SurfacePoint* surface, Color& color);
  // Batches are filled up.
  void (*evaluate_batch)(const CompiledPigment& pigment, int count, const PointBatch& points,
                         const SurfacePoint* const* surfaces, Color* colors, bool* colored);
  // Red, green and blue alone, of points without surfaces.
  void (*rgb_batch)(const CompiledPigment& pigment, int count, const PointBatch& points, RgbBatch& colors);
  void (*warp_batch)(const WarpChain& chain, int count, const PointBatch& from, PointBatch& to);
  void (*values_batch)(const CompiledPattern& pattern, int count, const PointBatch& warped_points,
                       const SurfacePoint* const* surfaces, double* values);
  void (*noise_batch)(int generator, int count, const PointBatch& points, double* noises);
  void (*turbulence_batch)(int generator, int count, const PointBatch& points, const Octaves& octaves, double* sums);
  void (*vector_noise_batch)(int count, const PointBatch& points, PointBatch& vectors);
  void (*wrinkles_batch)(int count, const PointBatch& points, PointBatch& vectors);
};

// `set` must not be beyond best_instruction_set().
const EvaluationKernels& evaluation_kernels(simd::InstructionSet set);

// `value_at` of several points, filled up.
void values_at(const CompiledPattern& pattern, int count, const PointBatch& warped_points,
               const SurfacePoint* const* surfaces, double* values);

}  // namespace verisim::textures
