#include "tracer/shapes/swept/sphere_sweep_packet.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/swept/sphere_sweep_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

#include "tracer/shapes/swept/sphere_sweep_side.inc"

void follow_packet(const SweepCubic& cubic, const LocalPacket& rays, SweepSidePacket& packet) {
  const Packet origin[3] = {load(rays.ox), load(rays.oy), load(rays.oz)},
               direction[3] = {load(rays.dx), load(rays.dy), load(rays.dz)};
  SweepSide<Packet> side;
  follow(cubic, origin, direction, side);
  for (int i = 0; i < 11; ++i) store(packet.power[i], side.power[i]);
}

const SweepFollow kKernels = follow_packet;

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(SweepFollow, sweep_follow)
}  // namespace verisim::shapes
#endif
