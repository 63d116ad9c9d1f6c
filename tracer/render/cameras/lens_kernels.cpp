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
void aim(const LensCamera& camera, const LensPoints& points, int count, RayBatch& rays) {
  const Vec3 &o = camera.location, &d = camera.direction, &r = camera.right, &u = camera.up, &a = camera.across,
             &b = camera.along;
  const double scale = camera.focal_scale;
  const int end = (count + RayBatch::kStep - 1) / RayBatch::kStep * RayBatch::kStep;
  for (int i = 0; i < end; ++i) {
    const double uc = (points.x[i] + camera.left + 0.5) / camera.width - 0.5,
                 wc = (camera.height - (points.y[i] + camera.top + 0.5)) / camera.height - 0.5;
    const double s = points.across[i], t = points.along[i];
    const double qx = s * a.x - t * b.x, qy = s * a.y - t * b.y, qz = s * a.z - t * b.z;
    double x = (d.x + uc * r.x + wc * u.x) * scale - qx, y = (d.y + uc * r.y + wc * u.y) * scale - qy,
           z = (d.z + uc * r.z + wc * u.z) * scale - qz;
    const double once = 1 / std::sqrt(x * x + y * y + z * z);
    x *= once, y *= once, z *= once;
    const double twice = 1 / std::sqrt(x * x + y * y + z * z);
    rays.direction.x[i] = x * twice, rays.direction.y[i] = y * twice, rays.direction.z[i] = z * twice;
    rays.origin.x[i] = o.x + qx, rays.origin.y[i] = o.y + qy, rays.origin.z[i] = o.z + qz;
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
