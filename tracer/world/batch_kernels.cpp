#include "tracer/world/batch_kernels.h"
#include <cmath>
#include <limits>
#include "tracer/shapes/quadrics/plane.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/world/batch_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/bvh/node_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::accel {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

void node_rays(const Box3& bounds, const Vec3& center, double slack, const RayBatch& rays, int first, double t_min,
               NodeRays& there) {
  const RayBatch::Vectors &o = rays.origin, &d = rays.direction;
  const double* const origin[3] = {o.x + first, o.y + first, o.z + first};
  const double* const direction[3] = {d.x + first, d.y + first, d.z + first};
  enter_tree(bounds, center, slack, origin, direction, t_min, there);
}

void children(const BoxNode& node, const NodeRays& rays, const double* limit, ChildrenMet& met) {
  test_children(node, rays, node_limits(rays, load(limit)), met);
}

unsigned before(const float* near, const NodeRays& rays, const double* limit) {
  return bits(FloatPacket::load(near) <= node_limits(rays, load(limit)));
}

unsigned plane(const Vec3& normal, double distance, const RayBatch& rays, int first, double t_min, const double* limit,
               double* t) {
  const double nx = normal.x, ny = normal.y, nz = normal.z;
  for (int i = 0; i < 8; ++i) {
    const int r = first + i;
    const double slope = nx * rays.direction.x[r] + ny * rays.direction.y[r] + nz * rays.direction.z[r];
    const double along = (distance - (nx * rays.origin.x[r] + ny * rays.origin.y[r] + nz * rays.origin.z[r])) / slope;
    t[i] = shapes::meets_plane(slope, along) ? along : -1;
  }
  const Packet met = load(t);
  return bits((met >= t_min) & (met < load(limit)));
}

const BatchKernels kKernels = {node_rays, children, before, plane};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::accel {
VERISIM_EXPORT_KERNELS(BatchKernels, batch_kernels)
}  // namespace verisim::accel
#endif
