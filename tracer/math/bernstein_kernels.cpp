#include "tracer/math/bernstein_packet.h"
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/math/bernstein_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

template <class Visit>
inline void each(unsigned lanes, Visit&& visit) {
  for (; lanes != 0; lanes &= lanes - 1) visit(__builtin_ctz(lanes));
}

unsigned begin(int n, unsigned active_mask, RootPacket& s) {
  Packet c[RootPacket::kMaxTerms];
  const Packet a = load(s.from), b = load(s.to);
  for (int i = 0; i <= n; ++i) c[i] = load(s.power[i]);
  if (const Mask moved = a != 0; bits(moved) != 0) {
    for (int i = 0; i < n; ++i)
      for (int k = n - 1; k >= i; --k) c[k] = select(moved, c[k] + a * c[k + 1], c[k]);
  }
  Packet scale = 1;
  const Packet width = b - a;
  for (int i = 0; i <= n; ++i, scale *= width) c[i] *= scale * bernstein::kBinomials.inverse[n][i];
  for (int i = 1; i <= n; ++i)
    for (int k = n; k >= i; --k) c[k] += c[k - 1];
  Mask positive = Mask::all(), negative = positive, finite = positive;
  for (int i = 0; i <= n; ++i) {
    positive &= c[i] > 0, negative &= c[i] < 0, finite &= abs(c[i]) < HUGE_VAL;
    store(s.now.c[i], c[i]);
  }
  store(s.now.from, a);
  store(s.now.to, b);
  for (int k = 0; k < kLanes; ++k) s.depth[k] = 0, s.waiting[k] = 0, s.found[k] = 0;
  s.done = 0;
  return s.open = bits(~positive & ~negative & finite) & active_mask;
}

// The intervals that wait for these lanes; those for which none does are closed.
inline void proceed(int n, unsigned lanes, RootPacket& s) {
  each(lanes, [&](int k) {
    if (s.waiting[k] == 0) {
      s.open &= ~(1u << k);
      return;
    }
    const int depth = 63 - __builtin_clzll(s.waiting[k]);
    s.waiting[k] &= ~(std::uint64_t{1} << depth);
    const RootPacket::Interval& next = s.later[depth];
    for (int i = 0; i <= n; ++i) s.now.c[i][k] = next.c[i][k];
    s.now.from[k] = next.from[k], s.now.to[k] = next.to[k];
    s.depth[k] = depth + 1;
  });
}

// Solver::bracketed_root, of intervals whose ends have values of opposite signs; other lanes hold anything.
inline Packet bracketed_roots(int n, unsigned lanes, const RootPacket& s) {
  Packet low = load(s.now.from), high = load(s.now.to);
  const Packet f_low = load(s.now.c[0]), f_high = load(s.now.c[n]);
  const Packet low_size = abs(low), high_size = abs(high);
  const Packet end_precision = 1e-15 * max(low_size, high_size);
  Packet x = low - f_low * (high - low) / (f_high - f_low);
  x = select((x > low) & (x < high), x, 0.5 * (low + high));
  Packet last_step = high - low;
  const Mask rises = f_low < 0;
  Mask active = Mask::of_bits(lanes);
  for (int step = 0; step < 100; ++step) {
    Packet f = load(s.power[n]), slope{};
    for (int i = n - 1; i >= 0; --i) slope = slope * x + f, f = f * x + load(s.power[i]);
    active &= f != 0;
    const Mask left = ~((f < 0) ^ rises);
    low = select(left, x, low);
    high = select(left, high, x);
    Packet next = x - f / slope;
    Packet move = abs(next - x);
    const Mask keeps = (next > low) & (next < high) & ~(move > 0.5 * last_step);
    next = select(keeps, next, 0.5 * (low + high));
    move = select(keeps, move, 0.5 * (high - low));
    last_step = move;
    x = select(active, next, x);
    active &= ~(move <= end_precision);
    if (bits(active) == 0) break;
  }
  return x;
}

unsigned next(int n, unsigned active_mask, RootPacket& s) {
  unsigned found = 0;
  const auto accept = [&](int k, double root) {
    if (s.found[k] > 0 && !(root > s.last[k])) return;
    s.root[k] = s.last[k] = root;
    found |= 1u << k;
    if (++s.found[k] >= n) s.open &= ~(1u << k);
  };
  for (;;) {
    proceed(n, s.done & s.open & active_mask & ~found, s);
    s.done &= ~(active_mask & ~found);
    unsigned bracketed = 0;
    while (const unsigned todo = s.open & active_mask & ~found & ~bracketed) {
      Packet changes{}, sign{};
      for (int i = 0; i <= n; ++i) {
        const Packet c = load(s.now.c[i]);
        changes = select(sign * c < 0, changes + 1.0, changes);
        sign = select(c != 0, select(c < 0, Packet(-1.0), Packet(1.0)), sign);
      }
      const Mask ends = (load(s.now.c[0]) != 0) & (load(s.now.c[n]) != 0);
      const unsigned none = bits(changes == 0.0) & todo, single = bits((changes == 1.0) & ends) & todo;
      bracketed |= single;
      // No change: a root at an end at most. One at the left end is taken away before the interval is looked at again
      // for the right one.
      each(none, [&](int k) {
        double inner = 1;
        for (int i = 0; i <= n; ++i) inner = s.now.c[i][k] != 0 ? s.now.c[i][k] : inner;
        if (s.now.c[0][k] == 0) {
          s.now.c[0][k] = inner;
          accept(k, s.now.from[k]);
        } else if (s.now.c[n][k] == 0) {
          s.now.c[n][k] = inner;
          accept(k, s.now.to[k]);
        } else {
          proceed(n, 1u << k, s);
        }
      });
      unsigned split = todo & ~none & ~single;
      if (split == 0) continue;
      each(split, [&](int k) {
        if (s.depth[k] < bernstein::kMaxDepth) return;
        split &= ~(1u << k);
        s.done |= 1u << k;
        accept(k, 0.5 * (s.now.from[k] + s.now.to[k]));
        if (!(found >> k & 1)) s.done &= ~(1u << k), proceed(n, 1u << k, s);
      });
      if (split == 0) continue;
      Packet right[RootPacket::kMaxTerms];
      for (int i = 0; i <= n; ++i) right[i] = load(s.now.c[i]);
      const Mask here = Mask::of_bits(split);
      for (int i = 0; i <= n; ++i) {  // de Casteljau at the middle
        store(s.now.c[i], select(here, right[0], load(s.now.c[i])));
        for (int k = 0; k < n - i; ++k) right[k] = 0.5 * (right[k] + right[k + 1]);
      }
      const Packet to = load(s.now.to), middle = 0.5 * (load(s.now.from) + to);
      store(s.now.to, select(here, middle, to));
      // Mostly, lanes are equally deep.
      for (unsigned rest = split; rest != 0;) {
        const std::int64_t depth = s.depth[__builtin_ctz(rest)];
        const Mask equal = Mask::of_bits(rest) & (load(s.depth) == IntPacket(depth));
        RootPacket::Interval& half = s.later[depth];
        for (int i = 0; i <= n; ++i) store(half.c[i], select(equal, right[i], load(half.c[i])));
        store(half.from, select(equal, middle, load(half.from)));
        store(half.to, select(equal, to, load(half.to)));
        rest &= ~bits(equal);
      }
      each(split, [&](int k) { s.waiting[k] |= std::uint64_t{1} << s.depth[k]++; });
    }
    if (bracketed == 0) return found;
    alignas(64) double roots[kLanes];
    store(roots, bracketed_roots(n, bracketed, s));
    s.done |= bracketed;
    each(bracketed, [&](int k) { accept(k, roots[k]); });
    if ((bracketed & ~found) == 0) return found;
  }
}

const BernsteinKernels kKernels = {begin, next};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim {
VERISIM_EXPORT_KERNELS(BernsteinKernels, bernstein_kernels)
}  // namespace verisim
#endif
