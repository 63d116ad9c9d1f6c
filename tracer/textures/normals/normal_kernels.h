// The arithmetic of normals that are found for a batch of points (normal_batch.cpp), compiled for several instruction
// sets. Every lane does the operations of the scalar code in the same order, so all give its bits. Batches are filled
// up; what stands behind is any number.
#pragma once

#include "tracer/simd/instruction_sets.h"
#include "tracer/textures/patterns/formulas.h"
#include "tracer/textures/point_batch.h"

namespace verisim::textures {

struct NormalKernels {
  // Like normal_into_frame and normal_out_of_frame, in place.
  void (*into_frame)(const CompiledPattern& pattern, bool no_bump_scale, int count, PointBatch& normals);
  void (*out_of_frame)(const CompiledPattern& pattern, bool no_bump_scale, int count, PointBatch& normals);
  // Adds amount * vectors.
  void (*displace)(double amount, int count, const PointBatch& vectors, PointBatch& normals);
  // Multiplies vectors by cubes.
  void (*scale_by_cubes)(double amount, int count, const double* factors, PointBatch& vectors);
  // Adds height * strength * direction.
  void (*raise)(const double* heights, double strength, const Vec3& direction, int count, PointBatch& normals);
  // How far the points are from a source of waves, as wave_distance() says, and the angles of its waves there.
  void (*wave_angles)(const WaveSource& source, const SourceWave& wave, int count, const PointBatch& points,
                      double* distances, double* angles);
  // Adds the slopes of its waves, whose sines are known there.
  void (*add_wave)(const WaveSource& source, const SourceWave& wave, int count, const PointBatch& points,
                   const double* distances, const double* sines, PointBatch& normals);
  // Adds factor * direction to points.
  void (*move)(const PointBatch& points, double factor, const Vec3& direction, int count, PointBatch& moved);
};

// Those of the best instruction set of this machine.
const NormalKernels& normal_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const NormalKernels* normal_kernels(int instruction_set);

}  // namespace verisim::textures
