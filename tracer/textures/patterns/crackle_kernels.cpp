#include "tracer/textures/patterns/crackle_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/textures/patterns/crackle_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::textures {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

// All lanes are smaller in magnitude than the limit.
HWY_INLINE bool all_within(const Packet& a, double limit) { return bits(abs(a) < limit) == 255; }

// Other orders of the lanes: 4-7 0-3; 23 01 67 45; 10 32 54 76.
HWY_INLINE Packet halves_swapped(const Packet& a) {
  constexpr int kVectors = Packet::kVectors;
  Packet r;
#if HWY_TARGET == HWY_AVX3
  static_assert(kVectors == 1);
  r.v[0] = hn::ConcatLowerUpper(Packet::D(), a.v[0], a.v[0]);
#else
  VERISIM_EACH_VECTOR r.v[i] = a.v[(i + kVectors / 2) % kVectors];
#endif
  return r;
}
HWY_INLINE Packet pairs_swapped(const Packet& a) {
  constexpr int kVectors = Packet::kVectors;
  Packet r;
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
  VERISIM_EACH_VECTOR r.v[i] = hn::SwapAdjacentBlocks(a.v[i]);
#else
  constexpr int kPair = 2 / Packet::kLanes;  // vectors
  VERISIM_EACH_VECTOR r.v[i] = a.v[i ^ kPair];
#endif
  return r;
}
HWY_INLINE Packet neighbours_swapped(const Packet& a) {
  constexpr int kVectors = Packet::kVectors;
  Packet r;
#if HWY_TARGET == HWY_SCALAR
  VERISIM_EACH_VECTOR r.v[i] = a.v[i ^ 1];
#else
  VERISIM_EACH_VECTOR r.v[i] = hn::Shuffle01(a.v[i]);
#endif
  return r;
}

// Three smallest of everything seen in each lane, ascending.
struct Smallest {
  Packet s0, s1, s2;

  HWY_INLINE void take(Packet d) {
    const Packet not_first = max(d, s0);
    s0 = min(d, s0);
    const Packet not_second = max(not_first, s1);
    s1 = min(not_first, s1);
    s2 = min(not_second, s2);
  }
  HWY_INLINE void merge(Packet t0, Packet t1, Packet t2) {
    s2 = min(min(max(t0, s1), max(t1, s0)), min(t2, s2));
    s1 = min(max(t0, s0), min(t1, s1));
    s0 = min(t0, s0);
  }
  HWY_INLINE NearestThree over_packet() {
    merge(halves_swapped(s0), halves_swapped(s1), halves_swapped(s2));
    merge(pairs_swapped(s0), pairs_swapped(s1), pairs_swapped(s2));
    merge(neighbours_swapped(s0), neighbours_swapped(s1), neighbours_swapped(s2));
    return {{s0[0], s1[0], s2[0]}};
  }
};

template <CrackleMetric metric>
HWY_INLINE Packet measured(Packet x, Packet y, Packet z) {
  if constexpr (metric == CrackleMetric::squares) return x * x + y * y + z * z;
  const Packet zero = Packet(0);
  return max(zero - x, x) + max(zero - y, y) + max(zero - z, z);
}

template <CrackleMetric metric>
NearestThree nearest_three(const CrackleCell& cell, const Vec3& p) {
  const Packet px = Packet(p.x), py = Packet(p.y), pz = Packet(p.z);
  const Packet far = Packet(1e300);
  Smallest best{far, far, far};
  for (int i = 0; i < cell.count; i += 8)
    best.take(measured<metric>(load(cell.x + i) - px, load(cell.y + i) - py, load(cell.z + i) - pz));
  return best.over_packet();
}

// Floor, as crackle has it.
HWY_INLINE Packet cell_of(Packet v) {
  const Packet below = v - Packet(kEpsilon), n = trunc(below);
  return n - select(below - n < 0.0, Packet(1), Packet(0.0));
}
bool locate(const double* x, const double* y, const double* z, CrackleEight& at) {
  const double* const p[3] = {x, y, z};
  bool one = true;
  for (int k = 0; k < 3; ++k) {
    const Packet v = load(p[k]), n = cell_of(v);
    store(at.cell[k], n);
    store(at.point[k], v);
    one = one && all_within(n - Packet(at.cell[k][0]), 0.5);
  }
  return one;
}
template <CrackleMetric metric>
void nearest_of_eight(const CrackleCell& cell, CrackleEight& at) {
  const Packet px = load(at.point[0]), py = load(at.point[1]), pz = load(at.point[2]);
  const Packet far = Packet(1e300);
  Smallest best{far, far, far};
  for (int i = 0; i < cell.count; ++i)
    best.take(measured<metric>(Packet(cell.x[i]) - px, Packet(cell.y[i]) - py, Packet(cell.z[i]) - pz));
  store(at.s[0], best.s0);
  store(at.s[1], best.s1);
  store(at.s[2], best.s2);
}

void in_form_of_eight(const CrackleEight& at, const double* form, double offset, bool roots, double* values) {
  Packet sum = Packet(0);
  for (int k = 0; k < 3; ++k) {
    if (form[k] == 0) continue;
    const Packet s = load(at.s[k]) + Packet(offset);
    sum = sum + Packet(form[k]) * (roots ? sqrt(s) : s);
  }
  store(values, min(max(sum, Packet(0)), Packet(1)));
}

// How near and how far a coordinate can be from a place in [0, 1].
HWY_INLINE Packet nearest(Packet q) { return max(Packet(0), max(q - Packet(1), Packet(0) - q)); }
HWY_INLINE Packet farthest(Packet q) { return max(max(q - Packet(1), Packet(1) - q), max(Packet(0) - q, q)); }

template <CrackleMetric metric>
double bound(const CrackleCell& cell, double* at_least) {
  const Packet far = Packet(1e300);
  Smallest best{far, far, far};
  for (int i = 0; i < cell.count; i += 8) {
    const Packet x = load(cell.x + i), y = load(cell.y + i), z = load(cell.z + i);
    store(at_least + i, measured<metric>(nearest(x), nearest(y), nearest(z)));
    best.take(measured<metric>(farthest(x), farthest(y), farthest(z)));
  }
  return best.over_packet().s[2];
}

constexpr CrackleKernels kKernels = {nearest_three<CrackleMetric::squares>,
                                     nearest_three<CrackleMetric::sums>,
                                     locate,
                                     nearest_of_eight<CrackleMetric::squares>,
                                     nearest_of_eight<CrackleMetric::sums>,
                                     in_form_of_eight,
                                     bound<CrackleMetric::squares>,
                                     bound<CrackleMetric::sums>};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::textures
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::textures {
VERISIM_EXPORT_KERNELS(CrackleKernels, crackle_kernels)
}  // namespace verisim::textures
#endif
