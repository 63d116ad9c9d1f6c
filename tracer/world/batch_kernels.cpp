#include "tracer/world/batch_kernels.h"
#include <cmath>
#include <limits>
#include "tracer/shapes/intersections.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/world/batch_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/bvh/node_rays-inl.h"
#include "tracer/shapes/local_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::accel {
namespace {
namespace HWY_NAMESPACE {

using namespace shapes::HWY_NAMESPACE;
using namespace simd::HWY_NAMESPACE;
#include "tracer/shapes/quadrics/plane_intersections.inc"

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
  Packet slope, along;
  const Mask met = plane_intersection(normal, distance, load_rays(rays.origin, first), load_rays(rays.direction, first),
                                      slope, along);
  store(t, select(met, along, -1.0));
  return bits(met & (along >= t_min) & (along < load(limit)));
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
