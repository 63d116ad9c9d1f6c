#include "tracer/textures/patterns/fractal_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/textures/patterns/fractal_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::textures {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

HWY_INLINE void leave_to_library(Packet& power, const Mask& known, const Packet& x, int k) {
  unsigned left = ~bits(known) & 0xff;
  if (left == 0) [[likely]]
    return;
  alignas(64) double powers[8], given[8];
  store(powers, power), store(given, x);
  for (; left != 0; left &= left - 1) {
    const int lane = std::countr_zero(left);
    powers[lane] = std::pow(given[lane], k);
  }
  power = load(powers);
}

#include "tracer/textures/patterns/fractal_orbit.inc"

template <class Step>
HWY_NOINLINE unsigned follow(const Step& step, int iterations, unsigned active, Orbits& o) {
  using Points = Complex<Packet>;
  Points z{load(o.zr), load(o.zi)}, known{HUGE_VAL, 0.0};
  const Points c{load(o.cr), load(o.ci)};
  Packet smallest = load(o.smallest);
  const auto keep = [&](unsigned lanes, Orbits& to) VERISIM_INLINE_LAMBDA {
    const Mask here = Mask::of_bits(lanes);
    store(to.zr, select(here, z.r, load(to.zr))), store(to.zi, select(here, z.i, load(to.zi)));
    store(to.smallest, select(here, smallest, load(to.smallest)));
  };
  unsigned escaped = 0;
  int known_at = 0, next = 1;
  for (int k = 0; k < iterations && active != 0; ++k) {
    z = step.next(z, c);
    const Packet size = squared(z);
    const Mask out = step.ends(z, size), round = (z.r == known.r) & (z.i == known.i);
    const unsigned ended = bits(out | round) & active;
    if (ended != 0) [[unlikely]] {
      const unsigned left = bits(out) & ended;
      smallest = select(out, smallest, select(size < smallest, size, smallest));
      keep(ended, o);
      for (unsigned rest = left; rest != 0; rest &= rest - 1) o.k[std::countr_zero(rest)] = k;
      for (unsigned rest = ended & ~left; rest != 0; rest &= rest - 1)
        o.left[std::countr_zero(rest)] = (iterations - k - 1) % (k - known_at);
      escaped |= left, active &= ~ended;
    }
    smallest = select(size < smallest, size, smallest);
    if (k == next) known = z, known_at = k, next = k < (1 << 29) ? 2 * k : 0;
  }
  keep(active, o);
  for (unsigned rest = active; rest != 0; rest &= rest - 1) o.left[std::countr_zero(rest)] = 0;
  return escaped;
}

unsigned follow(int magnet, int exponent, int iterations, unsigned active, Orbits& o) {
  return with_step(magnet, exponent, [&](const auto& step) { return follow(step, iterations, active, o); });
}

const OrbitKernels kKernels = {follow};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::textures
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::textures {
VERISIM_EXPORT_KERNELS(OrbitKernels, orbit_kernels)
}  // namespace verisim::textures
#endif
