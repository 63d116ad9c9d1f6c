// Points and directions of packets (tracer/simd/packet-inl.h), with the operations of vec.h in the same order.
// Included once for each target by kernels.
#if defined(VERISIM_MATH_PACKET_VECTOR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VERISIM_MATH_PACKET_VECTOR_INL_H
#undef VERISIM_MATH_PACKET_VECTOR_INL_H
#else
#define VERISIM_MATH_PACKET_VECTOR_INL_H
#endif

#include "tracer/math/transform.h"
#include "tracer/math/vec.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::simd {
namespace HWY_NAMESPACE {

template <class P>
struct PacketVector {
  P x, y, z;
};
template <class P>
HWY_INLINE P dot(const PacketVector<P>& a, const PacketVector<P>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class P>
HWY_INLINE P dot(const PacketVector<P>& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class P>
HWY_INLINE P dot(const Vec3& a, const PacketVector<P>& b) {
  return dot(b, a);
}
template <class P>
HWY_INLINE PacketVector<P> transform_point(const Affine& m, const PacketVector<P>& p) {
  return {p.x * m[0][0] + p.y * m[1][0] + p.z * m[2][0] + m[3][0],
          p.x * m[0][1] + p.y * m[1][1] + p.z * m[2][1] + m[3][1],
          p.x * m[0][2] + p.y * m[1][2] + p.z * m[2][2] + m[3][2]};
}
template <class P>
HWY_INLINE PacketVector<P> transform_direction(const Affine& m, const PacketVector<P>& d) {
  return {d.x * m[0][0] + d.y * m[1][0] + d.z * m[2][0], d.x * m[0][1] + d.y * m[1][1] + d.z * m[2][1],
          d.x * m[0][2] + d.y * m[1][2] + d.z * m[2][2]};
}
template <class P>
HWY_INLINE PacketVector<P> point_at(const PacketVector<P>& origin, const P& t, const PacketVector<P>& direction) {
  return {origin.x + t * direction.x, origin.y + t * direction.y, origin.z + t * direction.z};
}
template <class P>
HWY_INLINE PacketVector<P> select(const typename P::Mask& where, const PacketVector<P>& a, const PacketVector<P>& b) {
  return {select(where, a.x, b.x), select(where, a.y, b.y), select(where, a.z, b.z)};
}

}  // namespace HWY_NAMESPACE
}  // namespace verisim::simd
HWY_AFTER_NAMESPACE();

#endif
