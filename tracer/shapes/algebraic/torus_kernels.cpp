#include "tracer/shapes/algebraic/torus_packet.h"
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/algebraic/torus_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/shapes/intersections.h"
#include "tracer/shapes/local_rays-inl.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

#include "tracer/shapes/algebraic/torus_quartic.inc"

void quartic(double major, double minor, const Transform* matrix, const RayPacket& rays, TorusPacket& packet) {
  const LocalRays<Packet> l = local(matrix, rays);
  const TorusRadii radii{major, minor};
  packet.met = bits(meets_thick_cylinder(l.o, l.d, radii));
  if (packet.met == 0) return;
  Packet advance, c[4];
  torus_quartic(l.o, l.d, radii, advance, c);
  for (int i = 0; i < 4; ++i) store(packet.c[i], c[i]);
  store(packet.advance, advance), store(packet.scale, l.scale);
}

const TorusQuartic kKernels = quartic;

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(TorusQuartic, torus_quartic_kernel)
}  // namespace verisim::shapes
#endif
