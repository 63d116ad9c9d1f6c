#include <bit>
#include <cstdint>

#include "tracer/shapes/heights/height_walk.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/heights/height_walk_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

using SixteenFloats = BasicPacket<float, 16>;

// What the children of one block are tested with: sixteen floats.
struct RayNumbers {
  explicit RayNumbers(const HeightWalk::State& s)
      : x_steps(SixteenFloats::load(s.x_steps)),
        z_steps(SixteenFloats::load(s.z_steps)),
        enter(s.enter),
        height(s.height),
        slope(s.slope),
        height_margin(s.height_margin),
        skirt(s.side_margin * 4) {}
  SixteenFloats x_steps, z_steps, enter, height, slope, height_margin, skirt;
};

// A bit for each child that the ray may meet between its entry and `end`; near[c]: from where on. The first of them
// lies at (x0, z0) from the ray's origin.
HWY_INLINE unsigned meet(const HeightWalk::State& s, const RayNumbers& ray, const HeightGrid::Block& block, float x0,
                         float z0, float size, float end, float near[16]) {
  const float m = s.side_margin, beyond = size + m;
  const SixteenFloats near_x = (x0 + (s.backward_x ? beyond : -m)) * s.inverse_x,
                      far_x = (x0 + (s.backward_x ? -m : beyond)) * s.inverse_x;
  const SixteenFloats near_z = (z0 + (s.backward_z ? beyond : -m)) * s.inverse_z,
                      far_z = (z0 + (s.backward_z ? -m : beyond)) * s.inverse_z;
  const SixteenFloats dx = ray.x_steps * size, dz = ray.z_steps * size;
  const SixteenFloats a = max(ray.enter, max(near_z + dz, near_x + dx)),
                      b = min(SixteenFloats(end), min(far_z + dz, far_x + dx));
  const SixteenFloats ya = ray.height + a * ray.slope, yb = ray.height + b * ray.slope;
  const SixteenFloats low = SixteenFloats::load(block.low), high = SixteenFloats::load(block.high),
                      margin = ray.height_margin + (high - low) * ray.skirt;
  store(near, a);
  return bits((a <= b) & (low <= high) & (min(yb, ya) <= high + margin) & (low - margin <= max(yb, ya)));
}

int next(HeightWalk::State& s, float end, HeightCell* cells) {
  const RayNumbers ray(s);
  alignas(64) float near[16];
  while (s.waiting > 0) {
    const HeightWalk::Block at = s.blocks[--s.waiting];
    if (at.near > end) continue;
    const int below = at.level - 1, i = at.i * 4, k = at.k * 4;
    const double size = static_cast<double>(std::int64_t{1} << 2 * below);
    const auto x0 = static_cast<float>(i * size - s.origin.x), z0 = static_cast<float>(k * size - s.origin.z);
    unsigned met =
        in_order(meet(s, ray, s.grid->block(at.level, at.i, at.k), x0, z0, static_cast<float>(size), end, near),
                 s.backward_x, s.backward_z);
    if (met == 0) continue;
    if (below == 0) {
      int count = 0;
      for (; met != 0; met &= met - 1) {
        const int c = static_cast<int>(static_cast<unsigned>(std::countr_zero(met)) ^ s.flip);
        cells[count++] = {i + HeightGrid::column(c), k + HeightGrid::row(c), near[c]};
      }
      return count;
    }
    int place = s.waiting += std::popcount(met);
    for (; met != 0; met &= met - 1) {  // near ones last on the stack
      const int c = static_cast<int>(static_cast<unsigned>(std::countr_zero(met)) ^ s.flip);
      s.blocks[--place] = {below, i + HeightGrid::column(c), k + HeightGrid::row(c), near[c]};
    }
  }
  return 0;
}

constexpr HeightWalkKernels kKernels = {next};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(HeightWalkKernels, height_walk_kernels)
}  // namespace verisim::shapes
#endif
