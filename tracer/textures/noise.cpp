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

VERISIM_INLINE Vec4 splat(double x) { return Vec4{x, x, x, x}; }
VERISIM_INLINE double sum_lanes(Vec4 v) { return (v[0] + v[1]) + (v[2] + v[3]); }
VERISIM_INLINE const Vec4& row_of(const double* row) { return *reinterpret_cast<const Vec4*>(row); }
VERISIM_INLINE double clamp01(double v) { return v < 0 ? 0 : v > 1 ? 1 : v; }

// A lattice cell: position inside it and the weights of its corners; corner index = 4 cx + 2 cy + cz.
struct Cell {
  Vec4 d;
  alignas(32) double weight[8];
};

VERISIM_INLINE void set_weights(Cell& cell, double fx, double fy, double fz) {
  cell.d = Vec4{1, fx, fy, fz};
  const Vec4 s = cell.d * cell.d * (splat(3) - splat(2) * cell.d);
  const Vec4 y{1 - s[2], 1 - s[2], s[2], s[2]};
  const Vec4 z{1 - s[3], s[3], 1 - s[3], s[3]};
  const Vec4 yz = y * z;
  *reinterpret_cast<Vec4*>(cell.weight) = yz * splat(1 - s[1]);
  *reinterpret_cast<Vec4*>(cell.weight + 4) = yz * splat(s[1]);
}

VERISIM_INLINE double weighted_sum(const Cell& cell, const double (*table)[4], const unsigned* rows) {
  Vec4 q[8];
  for (int c = 0; c < 8; ++c) q[c] = splat(cell.weight[c]) * row_of(table[rows[c]]);
  const Vec4 q67 = q[6] + q[7], q45 = q[4] + q[5], q23 = q[2] + q[3];
  const Vec4 far_x = q45 + q67, far_y = q23 + q67, far_z = (q[1] + q[3]) + (q[5] + q[7]);
  const Vec4 all = ((q[0] + q[1]) + q23) + far_x;
  const Vec4 far = __builtin_shuffle(__builtin_shuffle(far_x, far_y, Mask4{0, 1, 6, 3}), far_z, Mask4{0, 1, 2, 7});
  const Vec4 dots = all * cell.d - Vec4{0, far[1], far[2], far[3]};
  return sum_lanes(dots);
}

// Floor, except that values within epsilon below an integer round up; far values saturate.
VERISIM_INLINE std::int64_t lattice(double x) {
  x = x < 0x1p62 ? x : 0x1p62;
  x = x > -0x1p62 ? x : -0x1p62;
  return static_cast<std::int64_t>(x >= 0 ? x : x - (1 - kEpsilon));
}

VERISIM_INLINE void find_lattice_cell(const NoiseTables& t, const Vec3& p, Cell& cell, unsigned* bytes) {
  const std::int64_t ix = lattice(p.x), iy = lattice(p.y), iz = lattice(p.z);
  set_weights(cell, p.x - static_cast<double>(ix), p.y - static_cast<double>(iy), p.z - static_cast<double>(iz));
  const auto low12 = [](std::int64_t i) { return static_cast<unsigned>(i & 4095); };
  const unsigned y0 = low12(iy + 10000), y1 = low12(iy + 10001), z0 = low12(iz + 10000), z1 = low12(iz + 10001);
  const unsigned x0 = t.hash[low12(ix + 10000)], x1 = t.hash[low12(ix + 10001)];
  const unsigned xy[4] = {t.hash[x0 ^ y0], t.hash[x0 ^ y1], t.hash[x1 ^ y0], t.hash[x1 ^ y1]};
  for (int k = 0; k < 4; ++k) {
    bytes[2 * k] = t.hash_byte[xy[k] ^ z0];
    bytes[2 * k + 1] = t.hash_byte[xy[k] ^ z1];
  }
}

VERISIM_INLINE double lattice_noise(const NoiseTables& t, const Vec3& p) {
  Cell cell;
  unsigned bytes[8];
  find_lattice_cell(t, p, cell, bytes);
  return weighted_sum(cell, t.value_row, bytes);
}

VERISIM_INLINE double gradient_noise(const NoiseTables& t, const Vec3& p) {
  constexpr double kShift = 10000000.023157213;
  const double tx = p.x + kShift, ty = p.y + kShift, tz = p.z + kShift;
  const std::int64_t ix = floor_to_int(tx), iy = floor_to_int(ty), iz = floor_to_int(tz);
  Cell cell;
  set_weights(cell, tx - static_cast<double>(ix), ty - static_cast<double>(iy), tz - static_cast<double>(iz));
  const auto low11 = [](std::int64_t i) { return static_cast<unsigned>(i & 2047); };
  const unsigned x0 = t.permutation[low11(ix)], x1 = t.permutation[low11(ix + 1)];
  const unsigned xy[4] = {t.permutation[low11(x0 + iy)], t.permutation[low11(x0 + iy + 1)], t.permutation[low11(x1 + iy)],
                          t.permutation[low11(x1 + iy + 1)]};
  unsigned rows[8];
  for (int k = 0; k < 4; ++k) {
    rows[2 * k] = low11(xy[k] + iz);
    rows[2 * k + 1] = low11(xy[k] + iz + 1);
  }
  return weighted_sum(cell, t.gradient_row, rows);
}

VERISIM_INLINE double scalar_noise(const NoiseTables& t, const Vec3& p, int generator) {
  if (generator == 3) return clamp01(0.5 * (1.59 * gradient_noise(t, p) + 0.985));
  const double n = lattice_noise(t, p);
  return clamp01(generator == 1 ? n + 0.5 : (n + 1.05242) * 0.48985582);
}

VERISIM_INLINE Vec3 three_noises(const NoiseTables& t, const Vec3& p) {
  Cell cell;
  unsigned bytes[8];
  find_lattice_cell(t, p, cell, bytes);
  return {weighted_sum(cell, t.value_row, bytes), weighted_sum(cell, t.value_row + 4, bytes), weighted_sum(cell, t.value_row + 8, bytes)};
}

}  // namespace

VERISIM_CLONES double noise(const Vec3& p, int generator) { return scalar_noise(noise_tables(), p, generator); }

VERISIM_CLONES Vec3 vector_noise(const Vec3& p) { return three_noises(noise_tables(), p); }

VERISIM_CLONES double turbulence(const Vec3& p, int octaves, double lambda, double omega, int generator) {
  const NoiseTables& t = noise_tables();
  double sum = scalar_noise(t, p, generator);
  if (generator != 1) sum = clamp01(2 * sum - 0.5);
  double scale = lambda, weight = omega;
  for (int i = 1; i < octaves; ++i, scale *= lambda, weight *= omega) {
    const double n = scalar_noise(t, p * scale, generator);
    sum += weight * (generator == 1 ? n : 2 * n - 0.5);
  }
  return sum;
}

VERISIM_CLONES Vec3 vector_turbulence(const Vec3& p, int octaves, double lambda, double omega) {
  const NoiseTables& t = noise_tables();
  Vec3 sum = three_noises(t, p);
  double scale = lambda, weight = omega;
  for (int i = 1; i < octaves; ++i, scale *= lambda, weight *= omega) sum += weight * three_noises(t, p * scale);
  return sum;
}

VERISIM_CLONES double granite_sum(const Vec3& p, int generator) {
  const NoiseTables& t = noise_tables();
  double sum = 0, scale = 4, weight = 1;
  for (int i = 0; i < 6; ++i, scale *= 2, weight /= 2) {
    const double n = scalar_noise(t, p * scale, generator);
    sum += weight * (generator == 1 ? std::fabs(0.5 - n) : std::min(0.5, std::fabs(1 - 2 * n)));
  }
  return sum;
}

VERISIM_CLONES double wrinkles_sum(const Vec3& p, int generator) {
  const NoiseTables& t = noise_tables();
  double sum = 0, scale = 1, weight = 1;
  for (int i = 0; i < 10; ++i, scale *= 2, weight /= 2) {
    const double n = scalar_noise(t, p * scale, generator);
    sum += weight * (generator == 1 ? n : clamp01(2 * n - 0.5));
  }
  return sum / 2;
}

}  // namespace verisim::textures
