#include "tracer/shapes/packet_kernels.h"
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/packet_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/shapes/local_rays-inl.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

void local_packet(const Transform* matrix, const RayPacket& rays, LocalPacket& packet) {
  const LocalRays<Packet> l = local(matrix, rays);
  store(packet.ox, l.o.x), store(packet.oy, l.o.y), store(packet.oz, l.o.z);
  store(packet.dx, l.d.x), store(packet.dy, l.d.y), store(packet.dz, l.d.z);
  store(packet.scale, l.scale);
}

const PacketKernels kKernels = {local_packet};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(PacketKernels, packet_kernels)
}  // namespace verisim::shapes
#endif
