// Eight rays against the boxes of a node: what kernels that walk a Bvh share (packet-inl.h says how such files are
// included).
#if defined(VERISIM_BVH_NODE_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VERISIM_BVH_NODE_RAYS_INL_H
#undef VERISIM_BVH_NODE_RAYS_INL_H
#else
#define VERISIM_BVH_NODE_RAYS_INL_H
#endif

#include <cmath>
#include <limits>

#include "tracer/bvh/node_rays.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::accel {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

// Eight rays in a tree with this centre, bounds and slack (bvh.h), at distances above t_min. Arrays of eight by axis.
HWY_INLINE void enter_tree(const Box3& bounds, const Vec3& center, double slack, const double* const origin[3],
                           const double* const direction[3], double t_min, NodeRays& there) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity(), kMax = 1e30;
  Packet start = t_min, end = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    const Packet along = load(direction[axis]), from = load(origin[axis]), inverse = Packet(1) / along;
    // A zero direction makes infinities of the right signs, or NaN on the very face, which the comparisons ignore.
    const Packet a = (Packet(bounds.min[axis]) - from) * inverse, b = (Packet(bounds.max[axis]) - from) * inverse;
    const Mask back = a > b;
    const Packet enter = select(back, b, a), leave = select(back, a, b);
    start = select(enter > start, enter, start);
    end = select(leave < end, leave, end);
    // In nodes infinity times zero would be NaN.
    store(there.inverse[axis], to_floats(select(abs(inverse) < Packet(kMax), inverse,
                                                select(along < Packet(0), Packet(-kMax), Packet(kMax)))));
  }
  for (int axis = 0; axis < 3; ++axis)
    store(there.origin[axis], to_floats(load(origin[axis]) - Packet(center[axis]) + start * load(direction[axis])));
  store(there.start, select(start <= end, start, Packet(kInfinity)));
  there.slack = slack;
}

// Those of the lanes that come near anything in the tree and whose numbers are fit to be compared with boxes.
HWY_INLINE unsigned entering(unsigned lanes, const NodeRays& there) {
  for (int k = 0; k < kLanes; ++k) {
    const float sum = there.origin[0][k] + there.origin[1][k] + there.origin[2][k];
    if (!(there.start[k] < HUGE_VAL && std::fabs(sum) < HUGE_VALF)) lanes &= ~(1u << k);
  }
  return lanes;
}

// Limits counted from where rays enter the tree, rounded up; below zero or NaN: nothing is nearer.
HWY_INLINE FloatPacket node_limits(const NodeRays& rays, const Packet& limit) {
  const Packet left = limit - load(rays.start) + Packet(rays.slack);
  return to_floats(left + abs(left) * Packet(3e-7));
}

// The children of a node that they meet before `end` (node_limits), and perhaps some that they narrowly miss.
HWY_INLINE void test_children(const BoxNode& node, const NodeRays& rays, const FloatPacket& end, ChildrenMet& met) {
  const FloatPacket ox = FloatPacket::load(rays.origin[0]), oy = FloatPacket::load(rays.origin[1]),
                    oz = FloatPacket::load(rays.origin[2]);
  const FloatPacket ix = FloatPacket::load(rays.inverse[0]), iy = FloatPacket::load(rays.inverse[1]),
                    iz = FloatPacket::load(rays.inverse[2]);
  const FloatPacket begin{};
  for (int k = 0; k < 4; ++k) {
    met.lanes[k] = 0;
    if (node.child[k] == 0) continue;  // the last node may not be full
    const auto at = [&](int plane, const FloatPacket& o, const FloatPacket& i) {
      return (node.planes[plane][k] - o) * i;
    };
    const FloatPacket ax = at(0, ox, ix), bx = at(3, ox, ix), ay = at(1, oy, iy), by = at(4, oy, iy),
                      az = at(2, oz, iz), bz = at(5, oz, iz);
    const FloatPacket enter = max(max(min(ax, bx), min(ay, by)), max(min(az, bz), begin));
    const FloatPacket leave = min(min(max(ax, bx), max(ay, by)), min(max(az, bz), end));
    store(met.near[k], enter);
    met.lanes[k] = bits(enter <= leave);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::accel
HWY_AFTER_NAMESPACE();

#endif
