#include "tracer/world/batch_kernels.h"
#include <cmath>
#include <limits>
#include "tracer/shapes/quadrics/plane.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/world/batch_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::accel {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

void node_rays(const Box3& bounds, const Vec3& center, double slack, const RayBatch& rays, int first, double t_min,
               NodeRays& there) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity(), kMax = 1e30;
  const RayBatch::Vectors &o = rays.origin, &d = rays.direction;
  Packet start = t_min, end = kInfinity;
  const auto clip = [&](const double* origin, const double* direction, double low, double high, float* inverse_out) {
    const Packet along = load(direction), from = load(origin), inverse = Packet(1) / along;
    // A zero direction makes infinities of the right signs, or NaN on the very face, which the comparisons ignore.
    const Packet a = (Packet(low) - from) * inverse, b = (Packet(high) - from) * inverse;
    const Mask back = a > b;
    const Packet enter = select(back, b, a), leave = select(back, a, b);
    start = select(enter > start, enter, start);
    end = select(leave < end, leave, end);
    // In nodes infinity times zero would be NaN.
    store(inverse_out, to_floats(select(abs(inverse) < Packet(kMax), inverse,
                                        select(along < Packet(0), Packet(-kMax), Packet(kMax)))));
  };
  clip(o.x + first, d.x + first, bounds.min.x, bounds.max.x, there.inverse[0]);
  clip(o.y + first, d.y + first, bounds.min.y, bounds.max.y, there.inverse[1]);
  clip(o.z + first, d.z + first, bounds.min.z, bounds.max.z, there.inverse[2]);
  store(there.origin[0], to_floats(load(o.x + first) - Packet(center.x) + start * load(d.x + first)));
  store(there.origin[1], to_floats(load(o.y + first) - Packet(center.y) + start * load(d.y + first)));
  store(there.origin[2], to_floats(load(o.z + first) - Packet(center.z) + start * load(d.z + first)));
  store(there.start, select(start <= end, start, Packet(kInfinity)));
  there.slack = slack;
}

// Limits counted from where rays enter the tree, rounded up; below zero or NaN: nothing is nearer.
HWY_INLINE FloatPacket limits(const NodeRays& rays, const double* limit) {
  const Packet left = load(limit) - load(rays.start) + Packet(rays.slack);
  return to_floats(left + abs(left) * Packet(3e-7));
}

void children(const BoxNode& node, const NodeRays& rays, const double* limit, ChildrenMet& met) {
  const FloatPacket ox = FloatPacket::load(rays.origin[0]), oy = FloatPacket::load(rays.origin[1]),
                    oz = FloatPacket::load(rays.origin[2]);
  const FloatPacket ix = FloatPacket::load(rays.inverse[0]), iy = FloatPacket::load(rays.inverse[1]),
                    iz = FloatPacket::load(rays.inverse[2]);
  const FloatPacket end = limits(rays, limit), begin{};
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

unsigned before(const float* near, const NodeRays& rays, const double* limit) {
  return bits(FloatPacket::load(near) <= limits(rays, limit));
}

void plane(const Vec3& normal, double distance, const RayBatch& rays, int first, double* t) {
  const double nx = normal.x, ny = normal.y, nz = normal.z;
  for (int i = 0; i < 8; ++i) {
    const int r = first + i;
    const double slope = nx * rays.direction.x[r] + ny * rays.direction.y[r] + nz * rays.direction.z[r];
    const double along = (distance - (nx * rays.origin.x[r] + ny * rays.origin.y[r] + nz * rays.origin.z[r])) / slope;
    t[i] = shapes::meets_plane(slope, along) ? along : -1;
  }
}

const BatchKernels kKernels = {node_rays, children, before, plane};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::accel {
VERISIM_EXPORT_KERNELS(BatchKernels, batch_kernels)
}  // namespace verisim::accel
#endif
