// Fast noise: the eight corners of a cell as rows of four doubles (constant and slopes), weighted and added with vector instructions.
//
// With q_c = w_c row_c and d = (1, f_x, f_y, f_z), the sum over corners of w_c row_c . (d - (0, c)) is  (sum q) . d  minus the x, y, z parts of
// those q whose corner lies on the far side of that axis. That saves building a vector for each corner. The compiler makes an AVX2 version and a
// baseline version of every function marked VERISIM_CLONES and the loader picks one; both do the same operations in the same order.
#include "tracer/textures/noise.h"

#include <algorithm>

#include "tracer/textures/noise_tables.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define VERISIM_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define VERISIM_CLONES
#endif
#define VERISIM_INLINE inline __attribute__((always_inline))
#pragma GCC diagnostic ignored "-Wpsabi"  // vectors are only passed between functions that are inlined

namespace verisim::textures {
namespace {

using Vec4 = double __attribute__((vector_size(32)));
using Mask4 = long long __attribute__((vector_size(32)));
using Int4 = int __attribute__((vector_size(16)));

VERISIM_INLINE double sum_lanes(Vec4 v) { return (v[0] + v[1]) + (v[2] + v[3]); }
// A row of a table by its offset in bytes.
VERISIM_INLINE const Vec4& row_at(const double (*table)[4], unsigned offset) {
  return *reinterpret_cast<const Vec4*>(reinterpret_cast<const char*>(table) + offset);
}
// Written so that they become single instructions; a jump would often be mispredicted.
VERISIM_INLINE double smaller(double a, double b) { return a < b ? a : b; }
VERISIM_INLINE double clamp01(double v) {
  v = v > 0 ? v : 0;
  return v < 1 ? v : 1;
}

// A lattice cell: position inside it, d = (1, f_x, f_y, f_z), and the weights of its corners; corner index = 4 cx + 2 cy + cz.
struct Cell {
  Vec4 d;
  Vec4 near_x, far_x;  // the four weights of the corners with cx = 0 and cx = 1
};

VERISIM_INLINE void set_weights(Cell& cell, Vec4 d) {
  cell.d = d;
  const Vec4 s = d * d * (3 - 2 * d), t = 1 - s;
  const Vec4 y = __builtin_shuffle(t, s, Mask4{2, 2, 6, 6});
  const Vec4 z = __builtin_shuffle(t, s, Mask4{3, 7, 3, 7});
  const Vec4 yz = y * z;
  cell.near_x = yz * t[1];
  cell.far_x = yz * s[1];
}

VERISIM_INLINE double weighted_sum(const Cell& cell, const double (*table)[4], const unsigned* offsets) {
  const Vec4 &n = cell.near_x, &f = cell.far_x;
  const Vec4 q0 = n[0] * row_at(table, offsets[0]), q1 = n[1] * row_at(table, offsets[1]), q2 = n[2] * row_at(table, offsets[2]), q3 = n[3] * row_at(table, offsets[3]);
  const Vec4 q4 = f[0] * row_at(table, offsets[4]), q5 = f[1] * row_at(table, offsets[5]), q6 = f[2] * row_at(table, offsets[6]), q7 = f[3] * row_at(table, offsets[7]);
  const Vec4 q67 = q6 + q7, q45 = q4 + q5, q23 = q2 + q3;
  const Vec4 far_x = q45 + q67, far_y = q23 + q67, far_z = (q1 + q3) + (q5 + q7);
  const Vec4 all = ((q0 + q1) + q23) + far_x;
  const Vec4 far = __builtin_shuffle(__builtin_shuffle(Vec4{}, far_x, Mask4{0, 5, 2, 3}), __builtin_shuffle(far_y, far_z, Mask4{0, 1, 2, 7}), Mask4{0, 1, 6, 7});
  return sum_lanes(all * cell.d - far);
}

// Coordinates as (0, x, y, z).
VERISIM_INLINE Vec4 in_lanes(const Vec3& p) { return Vec4{0, p.x, p.y, p.z}; }

// Beyond this, lattice coordinates do not fit into 32 bits; such points take the reference version.
constexpr double kFarthest = 1e9;
VERISIM_INLINE bool is_near(const Vec3& p) { return std::fabs(p.x) < kFarthest && std::fabs(p.y) < kFarthest && std::fabs(p.z) < kFarthest; }

VERISIM_INLINE void find_lattice_cell(const NoiseTables& t, const Vec3& p, Cell& cell, unsigned* offsets) {
  // Floor, except that values within epsilon below an integer round up.
  const Vec4 v = in_lanes(p);
  const Vec4 down = v < 0 ? Vec4{} + (1 - kEpsilon) : Vec4{};
  const Int4 i = __builtin_convertvector(v - down, Int4);
  set_weights(cell, v - __builtin_convertvector(i, Vec4) + Vec4{1, 0, 0, 0});
  const Int4 low = (i + 10000) & 4095, next = (i + 10001) & 4095;
  const auto x_low = static_cast<unsigned>(low[1]), x_next = static_cast<unsigned>(next[1]);
  const auto y_low = static_cast<unsigned>(low[2]), y_next = static_cast<unsigned>(next[2]);
  const auto z_low = static_cast<unsigned>(low[3]), z_next = static_cast<unsigned>(next[3]);
  const unsigned x0 = t.hash[x_low], x1 = t.hash[x_next];
  const unsigned xy0 = t.hash[x0 ^ y_low], xy1 = t.hash[x0 ^ y_next], xy2 = t.hash[x1 ^ y_low], xy3 = t.hash[x1 ^ y_next];
  offsets[0] = t.hash_row[xy0 ^ z_low];
  offsets[1] = t.hash_row[xy0 ^ z_next];
  offsets[2] = t.hash_row[xy1 ^ z_low];
  offsets[3] = t.hash_row[xy1 ^ z_next];
  offsets[4] = t.hash_row[xy2 ^ z_low];
  offsets[5] = t.hash_row[xy2 ^ z_next];
  offsets[6] = t.hash_row[xy3 ^ z_low];
  offsets[7] = t.hash_row[xy3 ^ z_next];
}

VERISIM_INLINE double lattice_noise(const NoiseTables& t, const Vec3& p) {
  Cell cell;
  unsigned offsets[8];
  find_lattice_cell(t, p, cell, offsets);
  return weighted_sum(cell, t.value_row, offsets);
}

VERISIM_INLINE double gradient_noise(const NoiseTables& t, const Vec3& p) {
  const Vec4 v = in_lanes(p) + 10000000.023157213;
  const Int4 truncated = __builtin_convertvector(v, Int4);
  const Vec4 toward_zero = __builtin_convertvector(truncated, Vec4);
  const Vec4 floor = toward_zero > v ? toward_zero - 1 : toward_zero;
  const Int4 i = __builtin_convertvector(floor, Int4);
  const Vec4 r = v - floor;
  Cell cell;
  set_weights(cell, Vec4{1, r[1], r[2], r[3]});
  const auto low11 = [](unsigned k) { return k & 2047; };
  constexpr unsigned kRow = sizeof t.gradient_row[0];
  const auto ix = static_cast<unsigned>(i[1]), iy = static_cast<unsigned>(i[2]), iz = static_cast<unsigned>(i[3]);
  const unsigned x0 = t.permutation[low11(ix)], x1 = t.permutation[low11(ix + 1)];
  const unsigned xy0 = t.permutation[low11(x0 + iy)], xy1 = t.permutation[low11(x0 + iy + 1)];
  const unsigned xy2 = t.permutation[low11(x1 + iy)], xy3 = t.permutation[low11(x1 + iy + 1)];
  const unsigned offsets[8] = {low11(xy0 + iz) * kRow, low11(xy0 + iz + 1) * kRow, low11(xy1 + iz) * kRow, low11(xy1 + iz + 1) * kRow,
                               low11(xy2 + iz) * kRow, low11(xy2 + iz + 1) * kRow, low11(xy3 + iz) * kRow, low11(xy3 + iz + 1) * kRow};
  return weighted_sum(cell, t.gradient_row, offsets);
}

template <int generator>
VERISIM_INLINE double scalar_noise(const NoiseTables& t, const Vec3& p) {
  if (!is_near(p)) [[unlikely]] return reference::noise(p, generator);
  if constexpr (generator == 3) return clamp01(0.5 * (1.59 * gradient_noise(t, p) + 0.985));
  const double n = lattice_noise(t, p);
  return clamp01(generator == 1 ? n + 0.5 : (n + 1.05242) * 0.48985582);
}

// Sum of weight^i f(N(scale^i p)).
template <int generator, class F>
VERISIM_INLINE double octave_sum(const Vec3& p, int octaves, double scale, double lambda, double omega, F f) {
  const NoiseTables& t = noise_tables();
  double sum = 0, weight = 1;
  for (int i = 0; i < octaves; ++i, scale *= lambda, weight *= omega) sum += weight * f(scalar_noise<generator>(t, p * scale));
  return sum;
}

template <int generator>
VERISIM_INLINE double turbulence_sum(const Vec3& p, int octaves, double lambda, double omega) {
  if constexpr (generator == 1) return octave_sum<1>(p, octaves, 1, lambda, omega, [](double n) { return n; });
  const double first = clamp01(2 * scalar_noise<generator>(noise_tables(), p) - 0.5);
  return first + omega * octave_sum<generator>(p, octaves - 1, lambda, lambda, omega, [](double n) { return 2 * n - 0.5; });
}

VERISIM_INLINE Vec3 three_noises(const NoiseTables& t, const Vec3& p) {
  if (!is_near(p)) [[unlikely]] return reference::vector_noise(p);
  Cell cell;
  unsigned offsets[8];
  find_lattice_cell(t, p, cell, offsets);
  return {weighted_sum(cell, t.value_row, offsets), weighted_sum(cell, t.value_row + 4, offsets), weighted_sum(cell, t.value_row + 8, offsets)};
}

}  // namespace

// One version of a function for each generator.
#define VERISIM_FOR_GENERATOR(generator, call) \
  switch (generator) {                         \
    case 1: {                                  \
      constexpr int G = 1;                     \
      return call;                             \
    }                                          \
    case 3: {                                  \
      constexpr int G = 3;                     \
      return call;                             \
    }                                          \
    default: {                                 \
      constexpr int G = 2;                     \
      return call;                             \
    }                                          \
  }

VERISIM_CLONES double noise(const Vec3& p, int generator) { VERISIM_FOR_GENERATOR(generator, scalar_noise<G>(noise_tables(), p)) }

VERISIM_CLONES Vec3 vector_noise(const Vec3& p) { return three_noises(noise_tables(), p); }

VERISIM_CLONES double turbulence(const Vec3& p, int octaves, double lambda, double omega, int generator) {
  VERISIM_FOR_GENERATOR(generator, turbulence_sum<G>(p, octaves, lambda, omega))
}

VERISIM_CLONES Vec3 vector_turbulence(const Vec3& p, int octaves, double lambda, double omega) {
  const NoiseTables& t = noise_tables();
  Vec3 sum = three_noises(t, p);
  double scale = lambda, weight = omega;
  for (int i = 1; i < octaves; ++i, scale *= lambda, weight *= omega) sum += weight * three_noises(t, p * scale);
  return sum;
}

VERISIM_CLONES double granite_sum(const Vec3& p, int generator) {
  VERISIM_FOR_GENERATOR(generator, octave_sum<G>(p, 6, 4, 2, 0.5, [](double n) { return G == 1 ? std::fabs(0.5 - n) : smaller(std::fabs(1 - 2 * n), 0.5); }))
}

VERISIM_CLONES double wrinkles_sum(const Vec3& p, int generator) {
  VERISIM_FOR_GENERATOR(generator, 0.5 * octave_sum<G>(p, 10, 1, 2, 0.5, [](double n) { return G == 1 ? n : clamp01(2 * n - 0.5); }))
}

}  // namespace verisim::textures
