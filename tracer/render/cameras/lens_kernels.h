// Lens rays of a perspective camera, many at once. Compiled for several instruction sets; all give the bits of
// FocalBlur::ray.
#pragma once

#include "tracer/math/ray_batch.h"

namespace verisim::render {

// Where the rays go through the picture and through the lens; behind them stand any numbers.
struct alignas(64) LensPoints {
  double x[RayBatch::kSize], y[RayBatch::kSize], across[RayBatch::kSize], along[RayBatch::kSize];
};

// A camera and its lens.
struct LensCamera {
  double width, height, left, top;  // of the picture, and what is rendered of it
  Vec3 location, direction, right, up;
  double focal_scale;  // focal distance over the length of the direction
  Vec3 across, along;  // unit vectors of the lens
};

struct LensKernels {
  // Their directions are unit vectors.
  void (*aim)(const LensCamera& camera, const LensPoints& points, int count, RayBatch& rays);
};

// Those of the best instruction set of this machine.
const LensKernels& lens_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const LensKernels* lens_kernels(int instruction_set);

}  // namespace verisim::render
