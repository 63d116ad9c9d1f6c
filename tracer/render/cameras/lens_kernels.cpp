#include "tracer/render/cameras/lens_kernels.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/render/cameras/lens_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "hwy/highway.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::render {
namespace {
namespace HWY_NAMESPACE {

// A plain loop, which the compiler turns into wide instructions.
void aim(const PerspectiveView& view, const Lens& lens, const LensPoints& points, int count, RayBatch& rays) {
  const int end = (count + RayBatch::kStep - 1) / RayBatch::kStep * RayBatch::kStep;
  for (int i = 0; i < end; ++i) {
    const Vec3 pinhole = view.through(view.place(points.x[i], points.y[i]));
    const Ray ray = lens.ray(points.across[i], points.along[i], pinhole);
    rays.origin.set(i, ray.origin), rays.direction.set(i, ray.direction);
  }
}

const LensKernels kKernels = {aim};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::render {
VERISIM_EXPORT_KERNELS(LensKernels, lens_kernels)
}  // namespace verisim::render
#endif
