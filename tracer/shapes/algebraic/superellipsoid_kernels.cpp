#include "tracer/shapes/algebraic/superellipsoid_packet.h"
#include <bit>
#include <cmath>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/algebraic/superellipsoid_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/functions/library-inl.h"
#include "tracer/math/power.h"
#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

// Plain loops, which the compiler turns into wide instructions. Conditions are written with & and |, so that nothing
// branches.

constexpr double kZero = 2e-10;  // of the value: twice what counts as a hit, so that no hit is passed by

template <int kLanes>
using Lane = double[kLanes];

std::int64_t flag(bool b) { return b ? 1 : 0; }

// x = x^y for 0 <= x <= 2 and y > 0, to about 1e-16 times the logarithm of the result; 0 below the normal numbers.
template <int kLanes>
void raise(Lane<kLanes>& xs, double y) {
  constexpr double kSmallest = -700;
  for (int i = 0; i < kLanes; ++i) {
    const double x = xs[i];
    const bool positive = x >= 0x1p-1000;
    const double t = y * power::logarithm<10>(positive ? x : 1.0);
    const bool visible = positive & (t > kSmallest);
    const double result = power::exponential(visible ? t : 0);
    xs[i] = visible ? result : 0;
  }
}

// The exponent as a small integer; 0: it is none.
int whole(double p) { return p >= 1 && p <= 64 && p == std::floor(p) ? static_cast<int>(p) : 0; }

// As most exponents in scenes are.
template <int kLanes>
void raise_whole(Lane<kLanes>& xs, int n) {
  alignas(64) Lane<kLanes> power;
  for (int i = 0; i < kLanes; ++i) power[i] = 1;
  for (; n != 0; n >>= 1) {
    if (n & 1)
      for (int i = 0; i < kLanes; ++i) power[i] *= xs[i];
    for (int i = 0; i < kLanes; ++i) xs[i] *= xs[i];
  }
  for (int i = 0; i < kLanes; ++i) xs[i] = power[i];
}

// x = x^(1/p) for 1 <= x <= 2.
template <int kLanes>
void take_root(Lane<kLanes>& xs, double p) {
  std::int64_t any = 0;
  for (int i = 0; i < kLanes; ++i) any |= flag(xs[i] > 1);
  if (any == 0) return;
  int n = whole(p);
  if (n == 0 || (n & (n - 1)) != 0) return raise(xs, 1 / p);
  for (; n > 1; n /= 2)
    for (int i = 0; i < kLanes; ++i) xs[i] = std::sqrt(xs[i]);
}

// |(a, b)|_p of values along a ray that are not negative, and its slope; into a.
template <int kLanes>
void norm(double p, Lane<kLanes>& value, Lane<kLanes>& slope, const Lane<kLanes>& other,
          const Lane<kLanes>& other_slope) {
  const double slope_of_zero = p == 1 ? 1 : 0;
  alignas(64) Lane<kLanes> large, small, large_slope, small_slope, u, root;
  for (int i = 0; i < kLanes; ++i) {
    const bool swapped = value[i] < other[i];
    large[i] = swapped ? other[i] : value[i], small[i] = swapped ? value[i] : other[i];
    large_slope[i] = swapped ? other_slope[i] : slope[i], small_slope[i] = swapped ? slope[i] : other_slope[i];
    const double ratio = small[i] / large[i];
    u[i] = ratio <= 1 ? ratio : 0;  // 0 / 0 and its like: whether they go through the root must not hang on other lanes
  }
  if (const int n = whole(p))
    raise_whole(u, n);
  else
    raise(u, p);
  for (int i = 0; i < kLanes; ++i) root[i] = 1 + u[i];
  take_root(root, p);
  for (int i = 0; i < kLanes; ++i) {
    const double size = large[i] * root[i],
                 beside = small[i] > 0 ? u[i] * small_slope[i] / small[i] : slope_of_zero * small_slope[i] / large[i];
    value[i] = large[i] > 0 ? size : 0;
    slope[i] = large[i] > 0 ? size / (1 + u[i]) * (large_slope[i] / large[i] + beside) : 0;
  }
}

// The value at lanes.t with its slope on the side of lanes.side.
template <int kLanes>
void along(double p, double q, const ConvexPacket& packet, Lane<kLanes>& value, Lane<kLanes>& slope) {
  alignas(64) Lane<kLanes> y, z, y_slope, z_slope;
  const auto size = [&](const double* origin, const double* direction, Lane<kLanes>& v, Lane<kLanes>& s) {
    for (int i = 0; i < kLanes; ++i) {
      const double d = direction[i], at = origin[i] + packet.t[i] * d, level = packet.side[i] * std::fabs(d);
      v[i] = std::fabs(at);
      s[i] = at == 0 ? level : at < 0 ? -d : d;
    }
  };
  size(packet.ox, packet.dx, value, slope);
  size(packet.oy, packet.dy, y, y_slope);
  size(packet.oz, packet.dz, z, z_slope);
  norm(p, value, slope, y, y_slope);
  norm(q, value, slope, z, z_slope);
  for (int i = 0; i < kLanes; ++i) value[i] -= 1;
}

template <int kLanes>
unsigned approach(double p, double q, unsigned active_mask, ConvexPacket& packet) {
  alignas(64) Lane<kLanes> values, slopes;
  alignas(64) std::int64_t active[kLanes], found[kLanes];
  for (int i = 0; i < kLanes; ++i) active[i] = active_mask >> i & 1, found[i] = 0;
  for (int step = 0; step < 100; ++step) {
    along(p, q, packet, values, slopes);
    std::int64_t any = 0;
    for (int i = 0; i < kLanes; ++i) {
      // The tangent lies below the curve: where it does not fall, or meets zero behind the end, there is nothing.
      const double t = packet.t[i], side = packet.side[i], next = t - values[i] / slopes[i];
      const std::int64_t arrived = flag(values[i] < kZero),
                         goes_on = flag(slopes[i] * side < 0) & flag((packet.end[i] - next) * side >= 0);
      const std::int64_t stays = flag(next == t), steps = active[i] & (1 - arrived) & goes_on & (1 - stays);
      found[i] |= active[i] & (arrived | (goes_on & stays));
      packet.t[i] = steps != 0 ? next : t;
      active[i] = steps;
      any |= steps;
    }
    if (any == 0) break;
  }
  for (int i = 0; i < kLanes; ++i) packet.value[i] = values[i], packet.slope[i] = slopes[i];
  unsigned result = 0;
  for (int i = 0; i < kLanes; ++i) result |= (found[i] | active[i]) != 0 ? 1u << i : 0;
  return result;
}

#if HWY_NATIVE_FMA
namespace library = functions::HWY_NAMESPACE;

// x^y where `wanted`; elsewhere anything.
HWY_INLINE library::Part power_of(const library::Part& x, double y, unsigned wanted) {
  library::Part result;
  unsigned unsure = library::power(x, library::Part(y), result) & wanted;
  if (unsure == 0) return result;
  double all[library::kPart];
  store(all, result);
  for (; unsure != 0; unsure &= unsure - 1) {
    const int k = std::countr_zero(unsure);
    all[k] = std::pow(x[k], y);
  }
  return library::Part::load(all);
}

HWY_INLINE library::Part raise(const EllipsoidNorm& norm, library::Part x, unsigned wanted) {
  if (norm.integer == 0) return power_of(x, norm.exponent, wanted);
  library::Part result(1.0);
  for (int n = norm.integer; n != 0; n >>= 1, x = x * x)
    if (n & 1) result = result * x;
  return result;
}

// EllipsoidNorm's formula.
HWY_INLINE library::Part norm_of(const EllipsoidNorm& norm, const library::Part& a, const library::Part& b,
                                 unsigned active) {
  const library::Part large = max(a, b), small = min(a, b);
  const library::PartMask some = large > 0.0;
  const library::Part ratio = small / select(some, large, library::Part(1.0));
  const library::PartMask two = some & (ratio >= norm.negligible);
  const unsigned both = bits(two) & active;
  const library::Part result = select(some, large, library::Part(0.0));
  if (both == 0) return result;
  const library::Part sum = 1.0 + raise(norm, select(two, ratio, library::Part(1.0)), both);
  const library::PartMask more = two & (sum != 1.0);
  const unsigned rooted = bits(more) & active;
  if (rooted == 0) return result;
  return select(more, large * power_of(sum, norm.inverse, rooted), result);
}
#endif

void norms(const EllipsoidNorm& across, const EllipsoidNorm& all, unsigned active, const EllipsoidPoints& points,
           double* norms) {
#if HWY_NATIVE_FMA
  for (int k = 0; k < EllipsoidPoints::kCount; k += library::kPart) {
    const unsigned here = active >> k & ((1u << library::kPart) - 1);
    if (here == 0) continue;
    const library::Part x = abs(library::Part::load(points.x + k)), y = abs(library::Part::load(points.y + k)),
                        z = abs(library::Part::load(points.z + k));
    store(norms + k, norm_of(all, norm_of(across, x, y, here), z, here));
  }
#else
  each_lane(active, [&](int k) {
    norms[k] = all(across(std::fabs(points.x[k]), std::fabs(points.y[k])), std::fabs(points.z[k]));
  });
#endif
}

const SuperellipsoidKernels kKernels = {approach<ConvexPacket::kCount>, approach<2>, norms};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(SuperellipsoidKernels, superellipsoid_kernels)
}  // namespace verisim::shapes
#endif
