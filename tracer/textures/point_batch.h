// Points that textures are asked for together: the hits of neighbouring camera rays.
#pragma once

#include "tracer/noise/noise.h"
#include "tracer/textures/texture.h"

namespace verisim::textures {

struct PointBatch {
  static constexpr int kMax = 64;  // a multiple of eight
  alignas(64) double x[kMax], y[kMax], z[kMax];

  Vec3 at(int i) const { return {x[i], y[i], z[i]}; }
  void set(int i, const Vec3& p) { x[i] = p.x, y[i] = p.y, z[i] = p.z; }
  // Lanes beyond the points repeat the last one, so that they need nothing of their own.
  void fill_up(int count) {
    for (int i = count; i % 8 != 0; ++i) set(i, at(count - 1));
  }
};

// Colours of the points of a batch.
struct RgbBatch {
  alignas(64) float r[PointBatch::kMax], g[PointBatch::kMax], b[PointBatch::kMax];
};

// The colours at the first `count` points, as `evaluate` gives them one by one, but faster. Filled up; `surfaces`: what
// is known of each hit, or null.
void evaluate(const CompiledPigment& pigment, int count, const PointBatch& points, const SurfacePoint* const* surfaces,
              Color* colors, bool* colored);
// The same for what needs no surface, without filter and transmittance.
void evaluate(const CompiledPigment& pigment, int count, const PointBatch& points, RgbBatch& colors);
// Noise summed over octaves at the first `count` points, filled up, as `turbulence` gives it one by one; as many values
// are written as there are points then, aligned as they are.
void turbulence(int generator, int count, const PointBatch& points, const Octaves& octaves, double* values);
// The normals to shade with at the first `count` points, as `perturb` gives them one by one; in and out.
void perturb(const CompiledNormal& normal, int count, const PointBatch& points, SurfacePoint* const* surfaces,
             Vec3* normals);

}  // namespace verisim::textures
