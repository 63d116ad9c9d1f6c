// Packets of rays in the space of a shape. Included once for each target by kernels.
#if defined(VERISIM_SHAPES_LOCAL_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VERISIM_SHAPES_LOCAL_RAYS_INL_H
#undef VERISIM_SHAPES_LOCAL_RAYS_INL_H
#else
#define VERISIM_SHAPES_LOCAL_RAYS_INL_H
#endif

#include "tracer/math/packet_vector-inl.h"
#include "tracer/math/ray_batch.h"
#include "tracer/math/transform.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

// Directions of unit length; world distance = local distance / scale.
template <class Number>
struct LocalRays {
  PacketVector<Number> o, d;
  Number scale;
};

// As Primitive::local: without a matrix the rays are left as they are.
template <class Number>
HWY_INLINE LocalRays<Number> local_rays(const Transform* matrix, const PacketVector<Number>& origin,
                                        const PacketVector<Number>& direction) {
  if (!matrix) return {origin, direction, Number(1.0)};
  const PacketVector<Number> d = transform_direction(matrix->inv, direction);
  const Number scale = sqrt(dot(d, d)), inverse = Number(1.0) / scale;
  return {transform_point(matrix->inv, origin), {d.x * inverse, d.y * inverse, d.z * inverse}, scale};
}

HWY_INLINE PacketVector<Packet> load_rays(const RayBatch::Vectors& v, int first) {
  return {Packet::load(v.x + first), Packet::load(v.y + first), Packet::load(v.z + first)};
}
HWY_INLINE LocalRays<Packet> local(const Transform* matrix, const RayPacket& rays) {
  return local_rays(matrix, load_rays(rays.rays.origin, rays.first), load_rays(rays.rays.direction, rays.first));
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#endif
