#include "tracer/shapes/swept/lathe_packet.h"
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/swept/lathe_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

unsigned along(const EightSegments& segments, const LathePassage& ray) {
  const Packet low = load(segments.y_low), high = load(segments.y_high);
  const Mask beside = (low > ray.y1 + ray.slack) | (high < ray.y0 - ray.slack);
  if (ray.inverse == 0) return bits(~beside);
  const Packet a = (low - ray.height) * ray.inverse, b = (high - ray.height) * ray.inverse;
  const Packet from = max(min(a, b), ray.near), to = min(max(a, b), ray.far);
  const auto distance2 = [&](const Packet& t) { return (ray.r * t + 2 * ray.m) * t + ray.c; };
  const Packet nearest = distance2(min(max(from, ray.turn), to)), farthest = max(distance2(from), distance2(to));
  return bits(~(beside | (from > to) | (nearest > load(segments.high2) + ray.doubt) |
                (farthest < load(segments.low2) - ray.doubt)));
}

unsigned begin(double outer2, unsigned active, LathePacket& s) {
  const Packet px = load(s.rays.ox), pz = load(s.rays.oz), dx = load(s.rays.dx), dz = load(s.rays.dz);
  const Packet r = dx * dx + dz * dz, m = dx * px + dz * pz, c = px * px + pz * pz;
  const Packet discriminant = m * m - r * (c - outer2), root = sqrt(discriminant);
  const Mask slanted = r > 1e-20;
  store(s.r, r), store(s.m, m), store(s.c, c);
  return bits((slanted & (discriminant >= 0.0) & ~((-m + root) / r < 0.0)) | (~slanted & (c <= outer2))) & active;
}

void follow(const CurveSegment& segment, const LathePacket& s, RootPacket& roots) {
  const Packet py = load(s.rays.oy), dy = load(s.rays.dy), r = load(s.r), m = load(s.m), c = load(s.c), dy2 = dy * dy,
               twice = 2.0 * dy * m;
  const int k = segment.degree;
  Packet y[4], power[7] = {};
  for (int i = 0; i <= k; ++i) y[i] = segment.c[static_cast<std::size_t>(i)].y;
  y[0] -= py;
  for (int i = 0; i <= k; ++i) {
    power[i] += twice * y[i];
    for (int j = 0; j <= k; ++j)
      power[i + j] +=
          r * y[i] * y[j] - dy2 * segment.c[static_cast<std::size_t>(i)].x * segment.c[static_cast<std::size_t>(j)].x;
  }
  power[0] += dy2 * c;
  for (int i = 0; i <= 2 * k; ++i) store(roots.power[i], power[i]);
  store(roots.from, Packet(0.0));
  store(roots.to, Packet(1.0));
}

const LatheKernels kKernels = {along, begin, follow};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(LatheKernels, lathe_kernels)
}  // namespace verisim::shapes
#endif
