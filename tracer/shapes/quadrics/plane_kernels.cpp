#include "tracer/shapes/quadrics/plane_set.h"
#include "tracer/shapes/intersections.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/quadrics/plane_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/shapes/local_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;
#include "tracer/shapes/quadrics/plane_intersections.inc"

constexpr double kFar = 1e300;

HWY_INLINE double least(const Packet& a) {
  alignas(64) double lanes[kLanes];
  store(lanes, a);
  double result = lanes[0];
  for (int k = 1; k < kLanes; ++k) result = lanes[k] < result ? lanes[k] : result;
  return result;
}

HWY_INLINE PacketVector<Packet> normals(const EightPlanes& p) { return {load(p.x), load(p.y), load(p.z)}; }

unsigned meet(const EightPlanes& planes, const Ray& ray, double doubt, double* t, double& enter, double& leave) {
  Packet slope, along;
  const Mask met = plane_intersection(normals(planes), load(planes.distance), ray.origin, ray.direction, slope, along);
  store(t, along);
  const Packet out = slope * load(planes.side), margin = doubt / abs(slope);
  const double first = least(select(out > kEpsilon, along + margin, kFar)),
               last = -least(select(out < -kEpsilon, margin - along, kFar));
  if (first < leave) leave = first;
  if (last > enter) enter = last;
  return bits(met);
}

unsigned behind(const EightPlanes& planes, const Vec3& p) {
  return bits(within_plane(normals(planes), load(planes.distance), p));
}

unsigned meet_batch(const EightPlanes& planes, int i, const RayBatch& rays, int first, const double* doubt, double* t,
                    double* enter, double* leave) {
  Packet slope, along;
  const Mask met = plane_intersection(Vec3(planes.x[i], planes.y[i], planes.z[i]), planes.distance[i],
                                      load_rays(rays.origin, first), load_rays(rays.direction, first), slope, along);
  store(t, along);
  const Packet out = slope * planes.side[i], margin = load(doubt) / abs(slope);
  store(leave, min(load(leave), select(out > kEpsilon, along + margin, kFar)));
  store(enter, max(load(enter), select(out < -kEpsilon, along - margin, -kFar)));
  return bits(met);
}

void clip_axis(double low, double high, const double* origin, const double* direction, double* near, double* far) {
  for (int k = 0; k < 8; ++k) {
    const double o = origin[k], d = direction[k], inverse = 1.0 / d, a = (low - o) * inverse, b = (high - o) * inverse;
    const double enter = a > b ? b : a, leave = a > b ? a : b;
    const bool misses = (o < low) | (o > high);
    const double from = d == 0 ? misses ? kFar : -kFar : enter, to = d == 0 ? misses ? -kFar : kFar : leave;
    near[k] = from > near[k] ? from : near[k];
    far[k] = to < far[k] ? to : far[k];
  }
}

void clip_batch(const Box3& box, const RayBatch& rays, int first, double* near, double* far) {
  clip_axis(box.min.x, box.max.x, rays.origin.x + first, rays.direction.x + first, near, far);
  clip_axis(box.min.y, box.max.y, rays.origin.y + first, rays.direction.y + first, near, far);
  clip_axis(box.min.z, box.max.z, rays.origin.z + first, rays.direction.z + first, near, far);
}

const PlaneKernels kKernels = {meet, behind, meet_batch, clip_batch};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(PlaneKernels, plane_kernels)
}  // namespace verisim::shapes
#endif
