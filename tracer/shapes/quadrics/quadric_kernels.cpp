#include "tracer/shapes/quadrics/quadric_kernels.h"
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/quadrics/quadric_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/shapes/intersections.h"
#include "tracer/shapes/local_rays-inl.h"
#include "tracer/shapes/nearest_of_eight-inl.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

#include "tracer/shapes/quadrics/box_intersections.inc"
#include "tracer/shapes/quadrics/cone_intersections.inc"
#include "tracer/shapes/quadrics/quadric_intersections.inc"
#include "tracer/shapes/quadrics/sphere_intersections.inc"

void sphere(const Vec3& center, double radius2, const Transform* matrix, const RayPacket& rays, double t_min,
            const double* t_max, PacketHits& met) {
  const LocalRays<Packet> l = local(matrix, rays);
  NearestOfEight<true> nearest(matrix ? &l.scale : nullptr, t_min, t_max);
  sphere_intersections(l.o, l.d, center, radius2, nearest);
  nearest.store_to(met);
}

// The direction keeps its length.
void box(const SimpleSolid& solid, const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) {
  PacketVector<Packet> o = load_rays(rays.rays.origin, rays.first), d = load_rays(rays.rays.direction, rays.first);
  if (solid.matrix) o = transform_point(solid.matrix->inv, o), d = transform_direction(solid.matrix->inv, d);
  NearestOfEight<false> nearest(nullptr, t_min, t_max);
  box_intersections(o, d, solid.a, solid.b, solid.turned, nearest);
  nearest.store_to(met);
}

void cone(bool cylinder, bool open, double narrow, const Transform* matrix, const RayPacket& rays, double t_min,
          const double* t_max, PacketHits& met) {
  const LocalRays<Packet> l = local(matrix, rays);
  NearestOfEight<false> nearest(matrix ? &l.scale : nullptr, t_min, t_max);
  cone_intersections(l.o, l.d, cylinder, open, narrow, nearest);
  nearest.store_to(met);
}

void quadric(const scene::Quadric& q, const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) {
  NearestOfEight<false> nearest(nullptr, t_min, t_max);
  quadric_intersections(load_rays(rays.rays.origin, rays.first), load_rays(rays.rays.direction, rays.first), q,
                        nearest);
  nearest.store_to(met);
}

const QuadricKernels kKernels = {sphere, box, cone, quadric};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(QuadricKernels, quadric_kernels)
}  // namespace verisim::shapes
#endif
