// Lens rays of a perspective camera, many at once. Compiled for several instruction sets; all give the same bits.
#pragma once

#include "tracer/math/perspective.h"
#include "tracer/math/ray_batch.h"

namespace verisim::render {

// Where the rays go through the picture and through the lens; behind them stand any numbers.
struct alignas(64) LensPoints {
  double x[RayBatch::kSize], y[RayBatch::kSize], across[RayBatch::kSize], along[RayBatch::kSize];
};

struct Lens {
  Vec3 location;       // of its middle
  double focal_scale;  // focal distance over the length of the camera's direction
  Vec3 across, along;  // unit vectors
  // From a point of the lens to what a ray of the pinhole camera has in focus.
  Ray ray(double s, double t, const Vec3& direction) const {
    const Vec3 q = s * across - t * along;
    // Twice, as POV-Ray does: walls of prisms in other surfaces show the last bit (spec 08 B).
    return {location + q, normalize(normalize(direction * focal_scale - q))};
  }
};

struct LensKernels {
  // Their directions are unit vectors.
  void (*aim)(const PerspectiveView& view, const Lens& lens, const LensPoints& points, int count, RayBatch& rays);
};

// Those of the best instruction set of this machine.
const LensKernels& lens_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const LensKernels* lens_kernels(int instruction_set);

}  // namespace verisim::render
