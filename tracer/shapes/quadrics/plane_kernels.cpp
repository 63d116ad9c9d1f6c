#include "tracer/shapes/quadrics/plane_set.h"
#include "tracer/shapes/quadrics/plane.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/quadrics/plane_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

constexpr double kFar = 1e300;

HWY_INLINE double least(const Packet& a) {
  alignas(64) double lanes[kLanes];
  store(lanes, a);
  double result = lanes[0];
  for (int k = 1; k < kLanes; ++k) result = lanes[k] < result ? lanes[k] : result;
  return result;
}

HWY_INLINE Mask meets(const Packet& slope, const Packet& t) {
  return ~(abs(slope) < kEpsilon) & (t >= kNearestPlane) & (t <= kFarthestPlane);
}

unsigned meet(const EightPlanes& planes, const Ray& ray, double doubt, double* t, double& enter, double& leave) {
  const Packet x = load(planes.x), y = load(planes.y), z = load(planes.z);
  const Packet slope = x * ray.direction.x + y * ray.direction.y + z * ray.direction.z;
  const Packet along = (load(planes.distance) - (x * ray.origin.x + y * ray.origin.y + z * ray.origin.z)) / slope;
  store(t, along);
  const Packet out = slope * load(planes.side), margin = doubt / abs(slope);
  const double first = least(select(out > kEpsilon, along + margin, kFar)),
               last = -least(select(out < -kEpsilon, margin - along, kFar));
  if (first < leave) leave = first;
  if (last > enter) enter = last;
  return bits(meets(slope, along));
}

unsigned behind(const EightPlanes& planes, const Vec3& p) {
  return bits(p.x * load(planes.x) + p.y * load(planes.y) + p.z * load(planes.z) - load(planes.distance) < kEpsilon);
}

unsigned meet_batch(const EightPlanes& planes, int i, const RayBatch& rays, int first, const double* doubt, double* t,
                    double* enter, double* leave) {
  const double x = planes.x[i], y = planes.y[i], z = planes.z[i];
  const Packet ox = load(rays.origin.x + first), oy = load(rays.origin.y + first), oz = load(rays.origin.z + first);
  const Packet dx = load(rays.direction.x + first), dy = load(rays.direction.y + first),
               dz = load(rays.direction.z + first);
  const Packet slope = x * dx + y * dy + z * dz, along = (planes.distance[i] - (x * ox + y * oy + z * oz)) / slope;
  store(t, along);
  const Packet out = slope * planes.side[i], margin = load(doubt) / abs(slope);
  store(leave, min(load(leave), select(out > kEpsilon, along + margin, kFar)));
  store(enter, max(load(enter), select(out < -kEpsilon, along - margin, -kFar)));
  return bits(meets(slope, along));
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
