#include "tracer/shapes/algebraic/poly_packet.h"
#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/algebraic/poly_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

#include "tracer/shapes/algebraic/poly_along.inc"

void along_packet(int order, const double* coefficients, const unsigned char* used, const LocalPacket& rays,
                  PolyPacket& packet) {
  const Packet o[3] = {load(rays.ox), load(rays.oy), load(rays.oz)},
               d[3] = {load(rays.dx), load(rays.dy), load(rays.dz)};
  Univariate<Packet> result;
  along(order, coefficients, used, o, d, result);
  packet.size = result.size;
  for (int i = 0; i < result.size; ++i) store(packet.c[i], result.c[i]);
}

const PolyAlong kKernels = along_packet;

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(PolyAlong, poly_along)
}  // namespace verisim::shapes
#endif
