#include "tracer/shapes/packet_kernels.h"
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/packet_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/shapes/crossings.h"
#include "tracer/shapes/local_rays-inl.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

#include "tracer/shapes/algebraic/torus_quartic.inc"
#include "tracer/shapes/quadrics/box_crossings.inc"
#include "tracer/shapes/quadrics/cone_crossings.inc"
#include "tracer/shapes/quadrics/quadric_crossings.inc"
#include "tracer/shapes/quadrics/sphere_crossings.inc"

using PacketRays = LocalRays<Packet>;

HWY_INLINE PacketVector<Packet> load(const RayBatch::Vectors& v, int first) {
  return {Packet::load(v.x + first), Packet::load(v.y + first), Packet::load(v.z + first)};
}
HWY_INLINE PacketRays local(const Transform* matrix, const RayPacket& rays) {
  return local_rays(matrix, load(rays.rays.origin, rays.first), load(rays.rays.direction, rays.first));
}

void local(const Transform* matrix, const RayPacket& rays, LocalPacket& packet) {
  const PacketRays l = local(matrix, rays);
  store(packet.ox, l.o.x), store(packet.oy, l.o.y), store(packet.oz, l.o.z);
  store(packet.dx, l.d.x), store(packet.dy, l.d.y), store(packet.dz, l.d.z);
  store(packet.scale, l.scale);
}

// Keeps what NearestHit keeps of each ray. kInOrder: crossings come by distance, so that the first of equal ones
// counts.
template <bool kInOrder>
class NearestOfEight {
 public:
  using Part = IntPacket;
  // `scale`: distances in the world are smaller by it; null: they are the same.
  HWY_INLINE NearestOfEight(const Packet* scale, double t_min, const double* t_max)
      : scale_(scale), t_min_(t_min), t_(Packet::load(t_max)), local_(0.0), part_(-1), found_{} {}

  HWY_INLINE bool any(const Mask& where) const { return bits(where) != 0; }
  HWY_INLINE bool operator()(const Packet& t, const Mask& where, const Part& part) {
    const Packet depth = scale_ ? t / *scale_ : t;
    const Mask within = where & (depth >= t_min_);
    Mask taken = within & (depth < t_);
    if constexpr (!kInOrder) taken |= within & found_ & (depth <= t_), found_ |= taken;
    t_ = select(taken, depth, t_), local_ = select(taken, t, local_), part_ = select(taken, part, part_);
    return false;
  }
  HWY_INLINE void store_to(PacketHits& met) const {
    store(met.t, t_), store(met.local, local_), store(met.part, part_);
  }

 private:
  const Packet* const scale_;
  const double t_min_;
  Packet t_, local_;
  IntPacket part_;
  [[maybe_unused]] Mask found_;
};

void sphere(const Vec3& center, double radius2, const Transform* matrix, const RayPacket& rays, double t_min,
            const double* t_max, PacketHits& met) {
  const PacketRays l = local(matrix, rays);
  NearestOfEight<true> nearest(matrix ? &l.scale : nullptr, t_min, t_max);
  sphere_crossings(l.o, l.d, center, radius2, nearest);
  nearest.store_to(met);
}

// The direction keeps its length.
void box(const Vec3& low, const Vec3& high, const Transform* matrix, const RayPacket& rays, double t_min,
         const double* t_max, PacketHits& met) {
  PacketVector<Packet> o = load(rays.rays.origin, rays.first), d = load(rays.rays.direction, rays.first);
  if (matrix) o = transform_point(matrix->inv, o), d = transform_direction(matrix->inv, d);
  NearestOfEight<true> nearest(nullptr, t_min, t_max);
  box_crossings(o, d, low, high, nearest);
  nearest.store_to(met);
}

void cone(bool cylinder, bool open, double narrow, const Transform* matrix, const RayPacket& rays, double t_min,
          const double* t_max, PacketHits& met) {
  const PacketRays l = local(matrix, rays);
  NearestOfEight<false> nearest(matrix ? &l.scale : nullptr, t_min, t_max);
  cone_crossings(l.o, l.d, cylinder, open, narrow, nearest);
  nearest.store_to(met);
}

void torus(double major, double minor, const Transform* matrix, const RayPacket& rays, TorusPacket& packet) {
  const PacketRays l = local(matrix, rays);
  const TorusRadii radii{major, minor};
  packet.met = bits(meets_thick_cylinder(l.o, l.d, radii));
  if (packet.met == 0) return;
  Packet advance, c[4];
  torus_quartic(l.o, l.d, radii, advance, c);
  for (int i = 0; i < 4; ++i) store(packet.c[i], c[i]);
  store(packet.advance, advance), store(packet.scale, l.scale);
}

void quadric(const scene::Quadric& q, const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) {
  NearestOfEight<false> nearest(nullptr, t_min, t_max);
  quadric_crossings(load(rays.rays.origin, rays.first), load(rays.rays.direction, rays.first), q, nearest);
  nearest.store_to(met);
}

const PacketKernels kKernels = {local, sphere, box, cone, torus, quadric};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(PacketKernels, packet_kernels)
}  // namespace verisim::shapes
#endif
